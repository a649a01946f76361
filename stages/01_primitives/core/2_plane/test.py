# SPDX-License-Identifier: MIT
"""Planes from both sides, away from the world's origin, with and without spheres; and the eye in a plane."""
from exercises import first_hits

EYE = """
[camera]
position = [0.5, 1, 4]
look_at = [0, 0.9, 0]
fov = 75
[background]
color = [0.2, 0.1, 0]
"""
PLANES = """[[planes]]
normal = [0.1, 1, 0]
point = [0, -0.5, 0]
[[planes]]
normal = [0.5, 0.1, -1]
point = [0, 0, -3]
"""
BALL = """[[spheres]]
center = [-0.3, 0.5, 0]
radius = 0.8
"""
IN_THE_EYE = """[[planes]]
normal = [0, 1, 0]
point = [7, 1, 3]
"""

MISTAKES = [
    ("t > 0.0f ?", "t >= 0.0f ?",
     "You see a plane that the eye lies in, at the distance 0. A ray misses the plane that it starts in."),
    ("t > 0.0f ? t : INFINITY", "t",
     "You see what lies behind the eye: a negative t is no hit."),
    ("(offset - dot(normal, ray.origin))", "(dot(normal, ray.origin) - offset)",
     "The numerator has the wrong sign: what you see are the planes behind the eye, mirrored in it."),
    ("/ dot(normal, ray.direction)", "",
     "You return the eye's distance from the plane, the same for all rays. Divide by dot(normal, ray.direction)."),
    ("(offset - dot(normal, ray.origin))", "offset",
     "Where the ray starts has no part in your t: take dot(normal, ray.origin) from the offset."),
    ("t > 0.0f ?", "t > 0.0f && dot(normal, ray.direction) < 0.0f ?",
     "You see planes from the front only. They are seen from both sides."),
    ("(offset - dot(normal, ray.origin))", "(-offset - dot(normal, ray.origin))",
     "The offset has the wrong sign: your planes lie on the other side of the world's origin."),
    ("dot(normal, ray.direction)", "fabs(dot(normal, ray.direction))",
     "You divide by the absolute value: a plane that the ray turns its back to is seen as well."),
]


def check(attempt):
    attempt.expect_each([
        (EYE + PLANES + BALL, "two planes and a sphere"),
        (EYE + PLANES, "two planes alone"),
        (EYE + IN_THE_EYE + BALL, "a plane that the eye lies in"),
        (EYE + BALL, "a sphere alone"),
    ], first_hits)
