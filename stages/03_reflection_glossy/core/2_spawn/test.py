# SPDX-License-Identifier: MIT
"""Mirrors that see each other, up to the depth limit, traced in double."""
from exercises import traced

EYE = """
[camera]
position = [0.3, 1.6, 5]
look_at = [0, 0.7, 0]
fov = 60
[background]
color = [0.1, 0.2, 0.3]
[trace]
max_depth = 3
[materials.gold]
type = "mirror"
color = [0.9, 0.7, 0.4]
[materials.varnish]
type = "glossy"
color = [0.8, 0.3, 0.3]
specularity = 0.4
[materials.chalk]
type = "diffuse"
color = [0.5, 0.8, 0.6]
"""
SHORT = EYE.replace("max_depth = 3", "max_depth = 1")
BALLS = """[[spheres]]
center = [-0.8, 0.8, 0]
radius = 0.8
material = "gold"
[[spheres]]
center = [0.9, 0.6, 0.3]
radius = 0.6
material = "varnish"
[[spheres]]
center = [0.1, 0.3, 1.2]
radius = 0.3
material = "gold"
"""
GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "chalk"
"""
LIGHTS = """[[lights]]
type = "point"
position = [2, 3, 3]
intensity = 6
[[lights]]
type = "directional"
direction = [0.6, -1, -0.7]
color = [0.2, 0.3, 0.4]
"""

RAY = "reflected.ray = reflected_ray(surface, incoming->ray.direction);"
MISTAKES = [
    ("reflected.weight = weight", "reflected.weight = incoming->weight",
     "Mirrors have no colour, and varnish reflects all: take the weight that you are given, not the incoming one."),
    ("reflected.weight = weight", "reflected.weight = weight * incoming->weight",
     "Second reflections are too dark: the incoming weight is in the one that you are given."),
    ("    ++reflected.depth;\n", "",
     "Rays go on beyond the depth limit: each bounce adds 1 to the depth."),
    ("++reflected.depth", "reflected.depth += 2",
     "The depth limit comes too early: each bounce adds 1 to the depth."),
    (RAY, "reflected.ray.origin = offset_ray_origin(surface, surface->normal);",
     "The ray goes on in its old direction: use reflected_ray."),
    (RAY, "reflected.ray.direction = reflect(incoming->ray.direction, surface->normal);",
     "The ray has a new direction and starts where the old one started: it starts at the surface."),
]


def check(attempt):
    for scene, what in ((EYE + GROUND + BALLS + LIGHTS, "mirrors and varnish on chalk"),
                        (SHORT + GROUND.replace("chalk", "varnish") + BALLS + LIGHTS, "mirrors on varnish, one bounce"),
                        (EYE + BALLS + LIGHTS, "spheres alone"),
                        (EYE + GROUND.replace("chalk", "varnish") + LIGHTS, "a plane alone"),
                        (EYE + GROUND + BALLS, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), traced(scene), what)
