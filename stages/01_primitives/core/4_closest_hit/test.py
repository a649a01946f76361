# SPDX-License-Identifier: MIT
"""Shapes behind each other in both orders, with and without planes or spheres, and an empty scene."""
from exercises import first_hits

EYE = """
[camera]
position = [0, 1, 4]
look_at = [0, 0.8, 0]
fov = 70
[background]
color = [0.2, 0.1, 0]
"""
BALLS = """[[spheres]]
center = [-0.8, 0.4, 2]
radius = 0.4
[[spheres]]
center = [-0.5, 0.9, 0.5]
radius = 0.9
[[spheres]]
center = [0.9, 0.7, -0.5]
radius = 0.9
[[spheres]]
center = [0.7, 0.5, 1]
radius = 0.5
"""
PLANES = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
[[planes]]
normal = [0.3, 0, 1]
point = [0, 0, -2]
"""

TRY = "keep_closer(closest, intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius), SHAPE_SPHERE, i);"
MISTAKES = [
    ("distance < closest->distance", "distance < INFINITY",
     "The last hit wins, not the nearest: compare with the distance that closest has already."),
    ("distance < closest->distance", "distance < INFINITY && (closest->shape == SHAPE_NONE || distance > closest->distance)",
     "The farthest hit wins: the comparison is the wrong way round."),
    ("    closest->distance = distance;\n", "",
     "The distance is not written into closest: it stays infinite, so each hit is nearer than that."),
    ("closest->index = index;", "closest->index = 0;",
     "Each hit is taken for the first shape of its kind: write the index into closest."),
    ("    closest->shape = shape;\n", "",
     "Nothing is seen but the background: write the shape into closest, which is SHAPE_NONE until then."),
    ("int i = 0;", "int i = 1;",
     "The first sphere is missing: indices begin with 0."),
    ("i < scene->sphere_count", "i < scene->sphere_count - 1",
     "The last sphere is missing: the loop ends one too early."),
    (TRY, TRY + " if (closest->shape == SHAPE_SPHERE) { break; }",
     "The first sphere that is hit wins: go on to the end of the list, since a later one may be nearer."),
    ("scene->spheres[i]", "scene->spheres[0]",
     "Only the first sphere is tried, again and again: the loop's index has no part in which one you read."),
]


def check(attempt):
    attempt.expect_each([
        (EYE + BALLS + PLANES, "spheres and planes"),
        (EYE + BALLS, "spheres alone"),
        (EYE + PLANES, "planes alone"),
        (EYE + "\n", "nothing at all"),
    ], first_hits)
