# SPDX-License-Identifier: MIT
"""A sphere from the front, from behind and from above: longitude and latitude in double."""
from core_scenes import PICTURE_SCENES, pictured

LATITUDE = "asin(clamp(normal.y, (float)(-1.0f), (float)(1.0f))) / PI"
MISTAKES = [
    ("atan2(normal.x, normal.z)", "atan2(normal.z, normal.x)",
     "The picture is mirrored and turned by a quarter: x is the first argument of atan2 and z the second."),
    ("0.5f + atan2", "atan2",
     "The picture's middle is at the back: 0.5 is missing in u."),
    ("(2.0f * PI)", "PI",
     "The picture is there twice around: a full turn is 2π."),
    ("0.5f - asin", "0.5f + asin",
     "The picture is upside down: v goes down from the north pole."),
    (LATITUDE, LATITUDE.replace("PI", "(2.0f * PI)"),
     "Only the middle of the picture is there, from pole to pole: half a turn is π."),
    ("atan2(normal.x, normal.z)", "atan2(-normal.x, normal.z)",
     "The picture is mirrored: u grows to the right, as seen from outside."),
    (LATITUDE, "0.5f * normal.y",
     "The picture is stretched near the poles: the latitude is an angle, the asin of y."),
    ("atan2(normal.x, normal.z)", "atan2(normal.x, normal.y)",
     "The picture turns about the wrong axis: y is up, so the longitude is that of x and z."),
]


def check(attempt):
    attempt.expect_each(PICTURE_SCENES, pictured)
