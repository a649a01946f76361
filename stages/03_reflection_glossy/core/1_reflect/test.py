# SPDX-License-Identifier: MIT
"""Mirrors on a plane and without one, traced in double."""
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

LAW = "direction - 2.0f * dot(direction, normal) * normal"
MISTAKES = [
    (LAW, "direction - dot(direction, normal) * normal",
     "Your rays run along the mirror: take the part across it away twice."),
    (LAW, "direction + 2.0f * dot(direction, normal) * normal",
     "Your rays go into the mirror: the part across it is taken away, and not added."),
    (LAW, "direction + 2.0f * normal",
     "You add two whole normals: it is as many as the direction goes along it, dot(direction, normal), taken away."),
    (LAW, "direction - 2.0f * direction * normal * normal",
     "You multiply component by component: the part along the normal is a dot product, one number."),
    (LAW, "normal",
     "Each mirror looks along its normal: the incoming direction has no part in your result."),
    (LAW, "-direction",
     "Rays go back where they came from: only the part across the mirror is turned round."),
]


def check(attempt):
    for scene, what in ((EYE + GROUND + BALLS + LIGHTS, "mirrors and varnish on chalk"),
                        (EYE + BALLS + LIGHTS, "spheres alone"),
                        (EYE + GROUND.replace("chalk", "varnish") + LIGHTS, "a plane alone"),
                        (EYE + GROUND + BALLS, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), traced(scene), what)
