# SPDX-License-Identifier: MIT
"""Spheres and planes in both kinds of light, and a wall with its light behind it."""
from core_scenes import LIT_BALLS, LIT_EYE, LIT_LIGHTS
from exercises import traced

GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
[[planes]]
normal = [0, 0, 1]
point = [0, 0, -2]
"""

COSINE = "dot(surface->normal, illumination.direction)"
MISTAKES = [
    (COSINE, f"fabs({COSINE})",
     "Surfaces are lit from behind: leave a negative cosine as it is."),
    (COSINE, f"-{COSINE}",
     "What faces the light is dark: the sign is wrong. Both vectors point away from the surface."),
    (COSINE, "dot(surface->normal, normalize(illumination.direction - surface->position))",
     "You take the surface's position from the direction. It is a direction already, and not the light's place."),
    (COSINE, f"{COSINE} * fabs({COSINE})",
     "Light falls off too fast towards the rim: that is the cosine's square."),
    (COSINE, f"0.5f + 0.5f * {COSINE}",
     "Your cosine goes from 0 to 1 on the way round to the dark side: it is the dot product as it is."),
    (COSINE, f"M_1_PI_F * {COSINE}",
     "All is too dark by the factor π: this course has it in the lights."),
    (COSINE, f"acos({COSINE})",
     "You take the angle itself. What counts is its cosine, which the dot product is."),
    (COSINE, f"sqrt(1.0f - {COSINE} * {COSINE})",
     "You take the sine: what faces the light is dark and what is lit at a slant is bright."),
]


def check(attempt):
    attempt.expect_each([
        (LIT_EYE + LIT_BALLS + GROUND + LIT_LIGHTS, "spheres and planes"),
        (LIT_EYE + LIT_BALLS + LIT_LIGHTS, "spheres alone"),
        (LIT_EYE + GROUND + LIT_LIGHTS, "planes alone"),
    ], traced)
