# SPDX-License-Identifier: MIT
"""A ball of glass and a bubble, traced in double."""
from core_scenes import GLASS_SCENES
from exercises import traced

MISTAKES = [
    ("slope_squared * slope_squared * slope", "slope_squared * slope_squared",
     "Rims reflect too much: that is the fourth power, and Schlick has the fifth."),
    ("root * root", "fabs(root)",
     "Glass reflects too much head on: the quotient is squared, 0.04 for common glass."),
    ("return head_on + (1.0f - head_on) * slope_squared * slope_squared * slope", "return head_on",
     "Glass reflects the same at all angles: it is a mirror at grazing angles, so the power has to be added."),
    ("(1.0f - head_on) *", "",
     "Rims reflect more light than arrives: the power is multiplied by what is left above the share head on."),
    ("1.0f - cosine", "cosine",
     "Glass is a mirror head on and clear at the rim: the power is that of 1 minus the cosine."),
    ("(1.0f - ior) / (1.0f + ior)", "(1.0f - ior) / ior",
     "The share head on is wrong: the difference of the indices is divided by their sum."),
]


def check(attempt):
    attempt.expect_each(GLASS_SCENES, traced)
