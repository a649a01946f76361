# SPDX-License-Identifier: MIT
"""A picture of few texels around a sphere, blended in double."""
from core_scenes import PICTURE_SCENES, pictured

OPTIONS = ["--method", "filtering=hand"]

BLEND = "mix(mix(a, b, share.x), mix(c, d, share.x), share.y)"
HALF = "floor(texel - 0.5f);\n    const float2 share = texel - 0.5f - low;"
MISTAKES = [
    (HALF, "floor(texel);\n    const float2 share = texel - low;",
     "The picture is shifted by half a texel: a texel's colour is that of its middle."),
    (BLEND, "mix(mix(a, b, share.y), mix(c, d, share.y), share.x)",
     "Colours jump from texel to texel: x and y are swapped, or the right texel and the lower one."),
    (BLEND, "0.25f * (a + b + c + d)",
     "There are blocks whose colour is the mean of four texels: blend by how near each is."),
    (BLEND, "mix(a, b, share.x)",
     "Texels are blended from left to right only: blend the two below, too, and then both by y."),
    (BLEND, "mix(a, c, share.y)",
     "Texels are blended from above to below only: blend by x, too."),
    (BLEND, "mix(mix(d, c, share.x), mix(b, a, share.x), share.y)",
     "Each texel is the stronger the farther it is: mix(a, b, x) is a where x is 0."),
    (BLEND, "a",
     "There are blocks, shifted by half a texel: that is one of the four. Blend them."),
]


def check(attempt):
    attempt.expect_each(PICTURE_SCENES, pictured)
