# SPDX-License-Identifier: MIT
"""A lamp without a range, and one whose range ends in the picture, on planes and spheres."""
from core_scenes import LIT_EYE
from exercises import traced

BALLS = """[[spheres]]
center = [-0.8, 0.8, 0]
radius = 0.8
material = "red"
"""
GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
"""
LAMP = """[[lights]]
type = "point"
position = [0.6, 1.9, 0.7]
color = [1, 0.9, 0.8]
intensity = 3
"""
RANGE = "range = 2.8\n"

MISTAKES = [
    ("(distance * distance)", "distance",
     "Light falls off with the distance; it falls off with its square."),
    ("(window * window / (distance * distance))", "window * window",
     "Light does not fall off at all inside its range: divide by the square of the distance."),
    ("window * window / ", "window / ",
     "The window is not squared: light ends with a kink at the range."),
    ("share < 1.0f ? 1.0f - share * share * share * share : 0.0f", "1.0f - share * share * share * share",
     "There is light again beyond the range: the window is below zero there, and its square is not."),
    ("share < 1.0f ? 1.0f - share * share * share * share : 0.0f", "1.0f",
     "The range is ignored: multiply by the window."),
    ("1.0f - share * share * share * share", "1.0f - share * share",
     "The window takes too much light near by: it has the fourth power of the share."),
    ("{to_light / distance,", "{-to_light / distance,",
     "The direction leads away from the light: it has to lead to it."),
]


def check(attempt):
    attempt.expect_each([
        (LIT_EYE + GROUND + BALLS + LAMP + RANGE, "a lamp with a range"),
        (LIT_EYE + GROUND + BALLS + LAMP, "a lamp without a range"),
        (LIT_EYE + BALLS + LAMP + RANGE, "a sphere alone"),
        (LIT_EYE + GROUND + LAMP + RANGE, "a plane alone"),
    ], traced)
