# SPDX-License-Identifier: MIT
"""Mirrors, varnish and chalk, traced in double."""
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

MISTAKES = [
    ("while (stack.count > 0)", "if (stack.count > 0)",
     "Mirrors are black: only the first ray is followed. Go on while one is waiting."),
    ("while (stack.count > 0)", "while (stack.count > 1)",
     "All is black: the first ray waits already, so begin with a count of 1."),
    ("color += incoming.weight * light", "color = incoming.weight * light",
     "Where a reflection sees the sky, the surface's own light is gone: add to the colour."),
    ("color += incoming.weight * light", "color += light",
     "The sky in mirrors is too bright and has no tint: multiply it by the ray's weight."),
    ("color += weight * direct", "color = weight * direct",
     "Only the last surface of each path is there: add to the colour."),
    ("color += weight * direct", "color += direct",
     "Surfaces are white and reflections too bright: multiply by the weight that shade has worked out."),
    ("color += weight * direct", "color += incoming.weight * direct",
     "Surfaces have lost their colour: that is the ray's weight. Take the one that shade has worked out."),
]


def check(attempt):
    for scene, what in ((EYE + GROUND + BALLS + LIGHTS, "mirrors and varnish on chalk"),
                        (EYE + BALLS + LIGHTS, "spheres alone"),
                        (EYE + GROUND.replace("chalk", "varnish") + LIGHTS, "a plane alone"),
                        (EYE + GROUND + BALLS, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), traced(scene), what)
