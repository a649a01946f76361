# SPDX-License-Identifier: MIT
"""Thick and thin glass, traced in double."""
from core_scenes import GLASS_SCENES
from exercises import traced

SHARE = "exp(-absorption * distance)"
MISTAKES = [
    (SHARE, "exp(absorption * distance)",
     "Glass makes light brighter: the exponent is negative."),
    (SHARE, "1.0f - absorption * distance",
     "Thick glass is darker than black: the share does not fall along a straight line. Take the exponential."),
    (SHARE, "max(1.0f - absorption * distance, (float3)(0.0f))",
     "Thick glass is black: the share does not fall along a straight line. Take the exponential."),
    (SHARE, "exp(-absorption)",
     "Thick and thin glass have one colour: multiply by the distance."),
    (SHARE, "exp((float3)(-distance))",
     "All glass is grey: multiply by the absorption."),
    (SHARE, "1.0f / (1.0f + absorption * distance)",
     "Light falls off too slowly in thick glass: two equal ways must take the same share each. Take the exponential."),
    (SHARE, "exp2(-absorption * distance)",
     "Glass is too bright: that is a power of 2, and Beer's law has one of e."),
]


def check(attempt):
    attempt.expect_each(GLASS_SCENES, traced)
