# SPDX-License-Identifier: MIT
"""Spheres before, behind and around a lamp and what it lights."""
from core_scenes import LIT_EYE
from exercises import traced

BALLS = """[[spheres]]
center = [0.4, 0.9, 0.4]
radius = 0.4
material = "red"
[[spheres]]
center = [-0.7, 3, 0]
radius = 0.4
[[spheres]]
center = [-0.5, -1.2, 0.6]
radius = 0.9
[[spheres]]
center = [2.2, 0.2, 1]
radius = 0.2
"""
AROUND_ALL = """[[spheres]]
center = [0, 0, 0]
radius = 30
"""
AROUND_THE_LAMP = """[[spheres]]
center = [0.1, 2, 0]
radius = 0.4
"""
GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
[[planes]]
normal = [1, 0, 0]
point = [-3, 0, 0]
"""
LAMP = """[[lights]]
type = "point"
position = [0, 2.1, 0.1]
intensity = 4
"""

ENDS = "nearest > 0.0f && nearest < 1.0f"
ONE_END = "return origin_inside != destination_inside;"
MISTAKES = [
    (ENDS, "nearest > 0.0f",
     "What stands behind the lamp casts a shadow: the line ends there, so the nearest point has to lie before its "
     "end."),
    (ENDS, "nearest < 1.0f",
     "What lies behind the surface casts a shadow: the nearest point has to lie after the line's origin."),
    ("dot(perpendicular, perpendicular) < radius_squared", "dot(perpendicular, perpendicular) < radius",
     "Shadows have the wrong size: the square of the perpendicular is compared with the square of the radius."),
    (ONE_END, "return true;",
     "A sphere around both the surface and the lamp is in the way: with both ends inside, nothing is crossed."),
    (ONE_END, "return false;",
     "Light gets out of a sphere around the lamp: with one end inside, the line crosses the sphere."),
    ("dot(to_center, along) / dot(along, along)", "dot(to_center, along)",
     "The nearest point is in the wrong place: along is not of unit length, so divide by its square."),
    ("center - line.origin", "line.origin - center",
     "The way from the origin to the centre has the wrong sign: spheres cast their shadows where there is no lamp."),
]


def check(attempt):
    attempt.expect_each([
        (LIT_EYE + GROUND + BALLS + LAMP, "small spheres, of which not all are in the way"),
        (LIT_EYE + GROUND + BALLS + AROUND_ALL + LAMP, "a sphere around all"),
        (LIT_EYE + GROUND + BALLS + AROUND_THE_LAMP + LAMP, "a sphere around the lamp"),
        (LIT_EYE + BALLS + LAMP, "spheres without planes"),
        (LIT_EYE + GROUND + LAMP, "planes without spheres"),
    ], traced)
