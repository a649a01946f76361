# SPDX-License-Identifier: MIT
"""Thick and thin glass, traced in double."""
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
SHARE = "exp(-absorption * distance)"
MISTAKES = [
    (SHARE, "exp(absorption * distance)",
     "Glass makes light brighter: the exponent is negative."),
    (SHARE, "1.0f - absorption * distance",
     "Thick glass is darker than black: the share does not fall along a straight line. Take the exponential."),
    (SHARE, "max(1.0f - absorption * distance, (float3)(0.0f))",
     "Thick glass is black: the share does not fall along a straight line. Take the exponential."),
    (SHARE, "exp(-absorption)",
     "Thick and thin glass have one colour: multiply by the distance."),
    (SHARE, "exp((float3)(-distance))",
     "All glass is grey: multiply by the absorption."),
    (SHARE, "1.0f / (1.0f + absorption * distance)",
     "Light falls off too slowly in thick glass: two equal ways must take the same share each. Take the exponential."),
    (SHARE, "exp2(-absorption * distance)",
     "Glass is too bright: that is a power of 2, and Beer's law has one of e."),
]


def check(attempt):
    for scene, what in ((EYE + GROUND + BALLS + LIGHTS, "glass and a bubble on chalk"),
                        (EYE + BALLS + LIGHTS, "spheres alone"),
                        (EYE + GROUND + LIGHTS, "a plane alone"),
                        (EYE + GROUND + BALLS, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), traced(scene), what)
