# SPDX-License-Identifier: MIT
"""Many spheres, each of them tried, in double: no box at all."""
from core_scenes import TREE_SCENES
from exercises import traced

MISTAKES = [
    ("inverse < 0.0f ? axis + 3 : axis]", "axis]",
     "Boxes are missing where a direction is below 0: the ray meets the high plane first there."),
    ("float4 enter = 0.0f", "float4 enter = -INFINITY",
     "Boxes around the ray's origin are missing: they are entered at 0, and not behind it."),
    ("enter <= leave", "enter > leave",
     "You enter the boxes that the ray misses: it is in a box when it enters before it leaves."),
    ("(float4)(-(origin[axis] + padding) * inverse)", "(float4)((origin[axis] + padding) * inverse)",
     "The near planes are in the wrong place: the origin is taken away."),
    ("leave = fmin(leave,", "leave = fmin((float4)(0.0f),",
     "Only boxes around the origin are entered: what is left of each axis is the smaller of its exit and leave."),
    ("leave = t_max", "leave = 1.0f",
     "Boxes farther away than 1 are missing: they may be entered up to t_max."),
]


def check(attempt):
    attempt.expect_each(TREE_SCENES, traced)
