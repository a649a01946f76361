# SPDX-License-Identifier: MIT
"""Two lights, with a wall that has one of them behind it; without spheres, planes or lights."""
from core_scenes import LIT_BALLS, LIT_EYE, LIT_LIGHTS
from exercises import traced

GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "red"
[[planes]]
normal = [0, 0, 1]
point = [0, 0, -2]
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
    attempt.expect_each([
        (LIT_EYE + GROUND + LIT_BALLS + LIT_LIGHTS, "spheres and planes in two lights"),
        (LIT_EYE + LIT_BALLS + LIT_LIGHTS, "spheres alone"),
        (LIT_EYE + GROUND + LIT_LIGHTS, "planes alone"),
        (LIT_EYE + LIT_BALLS + GROUND, "no light at all"),
    ], traced)
