# SPDX-License-Identifier: MIT
"""A ball of glass and a bubble, traced in double."""
from exercises import traced

EYE = """
[camera]
position = [0.3, 1.4, 4.6]
look_at = [0, 0.7, 0]
fov = 55
[background]
color = [0.4, 0.5, 0.7]
[trace]
max_depth = 4
[materials.glass]
type = "dielectric"
absorption = [0.1, 0.6, 0.9]
[materials.bubble]
type = "dielectric"
ior = 0.7
[materials.chalk]
type = "diffuse"
color = [0.5, 0.8, 0.6]
"""
BALLS = """[[spheres]]
center = [-0.8, 0.8, 0]
radius = 0.8
material = "glass"
[[spheres]]
center = [0.9, 0.6, 0.3]
radius = 0.6
material = "bubble"
[[spheres]]
center = [0.2, 0.4, -1.5]
radius = 0.4
material = "chalk"
"""
GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "chalk"
"""
LIGHTS = """[[lights]]
type = "point"
position = [2, 3, 3]
intensity = 8
[[lights]]
type = "directional"
direction = [0.6, -1, -0.7]
color = [0.2, 0.3, 0.4]
"""
MISTAKES = [
    ("slope_squared * slope_squared * slope", "slope_squared * slope_squared",
     "Rims reflect too much: that is the fourth power, and Schlick has the fifth."),
    ("root * root", "fabs(root)",
     "Glass reflects too much head on: the quotient is squared, 0.04 for common glass."),
    ("return head_on + (1.0f - head_on) * slope_squared * slope_squared * slope", "return head_on",
     "Glass reflects the same at all angles: it is a mirror at grazing angles, so the power has to be added."),
    ("(1.0f - head_on) *", "",
     "Rims reflect more light than arrives: the power is multiplied by what is left above the share head on."),
    ("1.0f - cosine", "cosine",
     "Glass is a mirror head on and clear at the rim: the power is that of 1 minus the cosine."),
    ("(1.0f - ior) / (1.0f + ior)", "(1.0f - ior) / ior",
     "The share head on is wrong: the difference of the indices is divided by their sum."),
]


def check(attempt):
    for scene, what in ((EYE + GROUND + BALLS + LIGHTS, "glass and a bubble on chalk"),
                        (EYE + BALLS + LIGHTS, "spheres alone"),
                        (EYE + GROUND + LIGHTS, "a plane alone"),
                        (EYE + GROUND + BALLS, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), traced(scene), what)
