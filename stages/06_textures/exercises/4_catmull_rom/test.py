# SPDX-License-Identifier: MIT
"""The curve by what is asked of it, values and slopes at both ends, in Hermite's form: no weights of four texels."""
import numpy as np
from exercises import hit_plane, rays, texels_of

SCENE = """
[camera]
position = [0.1, 0.05, 1.5]
look_at = [0, 0, 0]
fov = 62
[materials.picture]
type = "diffuse"
texture = "%s"
[[meshes]]
file = "board.obj"
material = "picture"
[[lights]]
type = "directional"
direction = [0, 0, -1]
"""
BOARD = """
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
vt -0.3 -0.2
vt 1.2 -0.2
vt 1.2 0.9
vt -0.3 0.9
vn 0 0 1
f 1/1/1 2/2/1 3/3/1 4/4/1
"""


def along(axis, texels, place):
    """The curve along one axis of an array of texels, at these places, (n,)."""
    low = np.floor(place).astype(int)
    t = (place - low).reshape((-1,) + (1,) * (texels.ndim - 1))
    texels = np.moveaxis(texels, axis, 0)
    before, start, end, after = (texels[(low + k) % len(texels)] for k in (-1, 0, 1, 2))
    out, into = (end - before) / 2, (after - start) / 2
    smooth = t * t * (3 - 2 * t)
    return start + smooth * (end - start) + t * (1 - t) ** 2 * out - t * t * (1 - t) * into


def cubic(texels, u, v):
    height, width = texels.shape[:2]
    rows = along(1, texels, u.ravel() * width - 0.5)  # (n, height, 3): each place's column of the picture
    places = v.ravel() * height - 0.5
    colors = np.array([along(0, row, places[i:i + 1])[0] for i, row in enumerate(rows)])
    return np.clip(colors, 0, 1).reshape(u.shape + (3,))


def check(attempt):
    (attempt.scratch / "board.obj").write_text(BOARD)
    for picture in ("checker.png", "gradient.png"):
        scene = SCENE % picture
        eye, direction = rays(scene)
        point = eye + hit_plane(eye, direction, [0, 0, 1], [0, 0, 0])[..., None] * direction
        seen = np.abs(point).max(axis=-1) < 1
        u = -0.3 + 0.75 * (1 + point[..., 0])
        v = 0.1 + 0.55 * (1 - point[..., 1])  # down, and in the file up
        expected = np.where(seen[..., None], cubic(texels_of(picture), u, v), 0)
        attempt.expect_same(attempt.render(scene=scene), expected, f"a cubic through {picture}", strays=0.002)
