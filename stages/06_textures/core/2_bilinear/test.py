# SPDX-License-Identifier: MIT
"""A picture of few texels around a sphere, blended in double."""
import numpy as np
from exercises import bilinear, closest, light_at, rays, texels_of

OPTIONS = ["--method", "filtering=hand"]
EYE = """
[camera]
position = [%s]
look_at = [0, 0, 0]
fov = 50
[background]
color = [0.1, 0.2, 0.3]
[materials.picture]
type = "diffuse"
texture = "gradient.png"
[[spheres]]
center = [0, 0, 0]
radius = 1
material = "picture"
[[lights]]
type = "directional"
direction = [%s]
"""
FRONT = EYE % ("0.6, 0.5, 2.9", "-0.5, -0.3, -1")
BACK = EYE % ("0.4, 0.3, -2.9", "-0.3, -0.3, 1")
POLE = EYE % ("0.3, 2.9, 0.3", "-0.3, -1, -0.2")
GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, -1, 0]
"""


def expected(scene):
    """What a sphere around the world's origin shows of its picture, in light."""
    eye, direction = rays(scene)
    distance, normal, index = closest(scene, eye, direction)
    q = np.where(index[..., None] == 0, normal, [0.0, 0, 1])
    u = 0.5 + np.arctan2(q[..., 0], q[..., 2]) / (2 * np.pi)
    v = 0.5 - np.arcsin(np.clip(q[..., 1], -1, 1)) / np.pi
    color = np.where(index[..., None] == 0, bilinear(texels_of("gradient.png"), u, v), 1)
    seen = np.isfinite(distance)
    color[seen] *= light_at(scene, (eye + np.where(seen, distance, 0)[..., None] * direction)[seen], normal[seen])
    return np.where(seen[..., None], color, [0.1, 0.2, 0.3])


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
    for scene, what in ((FRONT, "the front of a sphere"), (BACK + GROUND, "its back, where the edges of the picture meet"),
                        (POLE, "its north pole")):
        attempt.expect_same(attempt.render(scene=scene), expected(scene), what)
