# SPDX-License-Identifier: MIT
"""A ball of glass and a bubble, whose rim reflects all, traced in double."""
from core_scenes import GLASS_SCENES
from exercises import traced

SUM = "ratio * direction + beyond * normal"
MISTAKES = [
    (f"normalize({SUM})", "direction",
     "Rays go straight on through glass: the direction has to change."),
    ("sine_squared > 1.0f", "false",
     "Some pixels are NaN: return false where the square of the sine is above 1, before the root is taken."),
    ("ratio * cosine - sqrt", "ratio * cosine + sqrt",
     "Refracted rays come out on the side where they came from: the root is subtracted."),
    ("ratio * ratio *", "ratio *",
     "Rays are bent by the wrong angle: the square of the sine has the square of the ratio."),
    ("const float ratio, float3 *refracted) {",
     "const float inverse, float3 *refracted) {\n    const float ratio = 1.0f / inverse;",
     "Glass bends rays away from the normal and the bubble towards it: your ratio is upside down."),
    ("-dot(direction, normal)", "dot(direction, normal)",
     "The cosine has the wrong sign: direction and normal point against each other, so it is minus their dot product."),
]


def check(attempt):
    attempt.expect_each(GLASS_SCENES, traced)
