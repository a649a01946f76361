# SPDX-License-Identifier: MIT
"""Mirrors on a plane and without one, traced in double."""
from core_scenes import MIRROR_SCENES
from exercises import traced

LAW = "direction - 2.0f * dot(direction, normal) * normal"
MISTAKES = [
    (LAW, "direction - dot(direction, normal) * normal",
     "Your rays run along the mirror: take the part across it away twice."),
    (LAW, "direction + 2.0f * dot(direction, normal) * normal",
     "Your rays go into the mirror: the part across it is taken away, and not added."),
    (LAW, "direction + 2.0f * normal",
     "You add two whole normals: it is as many as the direction goes along it, dot(direction, normal), taken away."),
    (LAW, "direction - 2.0f * direction * normal * normal",
     "You multiply component by component: the part along the normal is a dot product, one number."),
    (LAW, "normal",
     "Each mirror looks along its normal: the incoming direction has no part in your result."),
    (LAW, "-direction",
     "Rays go back where they came from: only the part across the mirror is turned round."),
]


def check(attempt):
    attempt.expect_each(MIRROR_SCENES, traced)
