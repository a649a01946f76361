# SPDX-License-Identifier: MIT
"""Spheres and planes in both kinds of light, and a wall with its light behind it."""
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
    for scene, what in ((EYE + BALLS + GROUND + LIGHTS, "spheres and planes"),
                        (EYE + BALLS + LIGHTS, "spheres alone"),
                        (EYE + GROUND + LIGHTS, "planes alone")):
        attempt.expect_same(attempt.render(scene=scene), traced(scene), what)
