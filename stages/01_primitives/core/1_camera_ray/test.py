# SPDX-License-Identifier: MIT
"""A leaning camera away from the world's origin, in pictures wider and higher than a square."""
from exercises import first_hits

BALLS = """
[camera]
position = [2, 1.5, 5]
look_at = [0.4, 0.9, 0]
up = [0.25, 1, 0]
fov = 70
[[spheres]]
center = [0, 1, 0]
radius = 1
[[spheres]]
center = [2.4, 0.6, 1]
radius = 0.6
[[spheres]]
center = [0.5, 0.5, 9]
radius = 2
"""
GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
"""

MISTAKES = [
    ("JOIN(TO_REAL, 2)(pixel) + XY(camera->sample)", "JOIN(TO_REAL, 2)(pixel)",
     "Your rays go through the pixels' upper left corners: all is shifted by half a pixel. Add sample to the pixel."),
    ("normalize(direction)", "direction",
     "Your directions are not of unit length: the contour lines of equal distance are straight and should be round."),
    ("+ point.y * XYZ(camera->down)", "- point.y * XYZ(camera->down)",
     "Rows go up and should go down: the first one is at the top, and each step down is added."),
    ("point.x * XYZ(camera->right) + point.y * XYZ(camera->down)",
     "point.y * XYZ(camera->right) + point.x * XYZ(camera->down)",
     "Columns and rows are swapped: x counts steps to the right, y steps down."),
    ("XYZ(camera->corner) +", "XYZ(camera->corner) - XYZ(camera->position) +",
     "You take the eye's position from the direction. The corner is a direction already, and not a point."),
    ("{XYZ(camera->position),", "{(float3)(0.0f),",
     "Your rays start at the world's origin. They start where the eye is, at the camera's position."),
    ("normalize(direction)", "-normalize(direction)",
     "You look backwards: the direction has the wrong sign."),
    ("point.x * XYZ(camera->right)", "(convert_float(camera->size.x) - point.x) * XYZ(camera->right)",
     "Left and right are swapped: columns are counted from the left."),
]


def check(attempt):
    for scene, what, size in ((BALLS + GROUND, "spheres on a plane", (160, 96)),
                              (BALLS, "spheres alone, in a picture higher than wide", (64, 120)),
                              (BALLS.split("[[spheres]]")[0] + GROUND, "a plane alone", (96, 96))):
        attempt.expect_same(attempt.render(scene=scene, size=size), first_hits(scene, size), what)
