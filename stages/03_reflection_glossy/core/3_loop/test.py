# SPDX-License-Identifier: MIT
"""Mirrors, varnish and chalk, traced in double."""
from core_scenes import MIRROR_SCENES
from exercises import traced

MISTAKES = [
    ("while (stack.count > 0)", "if (stack.count > 0)",
     "Mirrors are black: only the first ray is followed. Go on while one is waiting."),
    ("while (stack.count > 0)", "while (stack.count > 1)",
     "All is black: the first ray waits already, so begin with a count of 1."),
    ("color += incoming.weight * light", "color = incoming.weight * light",
     "Where a reflection sees the sky, the surface's own light is gone: add to the colour."),
    ("color += incoming.weight * light", "color += light",
     "The sky in mirrors is too bright and has no tint: multiply it by the ray's weight."),
    ("color += weight * direct", "color = weight * direct",
     "Only the last surface of each path is there: add to the colour."),
    ("color += weight * direct", "color += direct",
     "Surfaces are white and reflections too bright: multiply by the weight that shade has worked out."),
    ("color += weight * direct", "color += incoming.weight * direct",
     "Surfaces have lost their colour: that is the ray's weight. Take the one that shade has worked out."),
]


def check(attempt):
    attempt.expect_each(MIRROR_SCENES, traced)
