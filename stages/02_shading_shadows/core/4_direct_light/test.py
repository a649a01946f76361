# SPDX-License-Identifier: MIT
"""Two lights, with a wall that has one of them behind it; without spheres, planes or lights."""
from exercises import traced

EYE = """
[camera]
position = [0, 1.6, 5]
look_at = [0, 0.7, 0]
fov = 60
[background]
color = [0.1, 0.2, 0.3]
[materials.red]
type = "diffuse"
color = [0.9, 0.4, 0.3]
"""
BALLS = """[[spheres]]
center = [-0.8, 0.8, 0]
radius = 0.8
material = "red"
[[spheres]]
center = [1, 0.5, 0.5]
radius = 0.5
"""
GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "red"
[[planes]]
normal = [0, 0, 1]
point = [0, 0, -2]
"""
LIGHTS = """[[lights]]
type = "point"
position = [2, 3, 3]
intensity = 6
[[lights]]
type = "directional"
direction = [0.6, -1, 0.7]
color = [0.2, 0.3, 0.4]
"""

SHADOW = "!in_shadow(scene, light, offset_ray_origin(surface, illumination.direction))"
MISTAKES = [
    (SHADOW, "true",
     "Nothing casts a shadow: add a light only where in_shadow says no."),
    ("cosine > 0.0f", "true",
     "A light behind a surface takes light away: its cosine is negative. Add only where it is above zero."),
    ("sum += cosine", "sum = cosine",
     "Only the last light that arrives is there: add each to the sum."),
    ("offset_ray_origin(surface, illumination.direction)", "surface->position",
     "Surfaces shadow themselves in specks: the shadow ray starts in the surface. Start it a little off it."),
    ("offset_ray_origin(surface, illumination.direction)", "offset_ray_origin(surface, -illumination.direction)",
     "Surfaces shadow themselves: the shadow ray starts on the side that the light is not on."),
    ("cosine * illumination.irradiance", "illumination.irradiance",
     "Spheres are flat discs with shadows: the irradiance is not multiplied by the cosine."),
    ("cosine * illumination.irradiance", "cosine",
     "All lights are white and equally bright: multiply by the irradiance."),
    ("!in_shadow", "in_shadow",
     "What should be lit is dark and what is in the shadow is lit: in_shadow says where light does not arrive."),
]


def check(attempt):
    for scene, what in ((EYE + GROUND + BALLS + LIGHTS, "spheres and planes in two lights"),
                        (EYE + BALLS + LIGHTS, "spheres alone"),
                        (EYE + GROUND + LIGHTS, "planes alone"),
                        (EYE + BALLS + GROUND, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), traced(scene), what)
