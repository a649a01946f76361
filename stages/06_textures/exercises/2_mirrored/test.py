# SPDX-License-Identifier: MIT
"""Tiles as a picture of two by two, put together from the texture and its mirror images, shows them."""
import numpy as np
from exercises import bilinear, hit_plane, rays, texels_of

REPEATS = 3
EXACT = "--method", "filtering=hand"  # whatever precision the device's own filter has
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


def board(left, right, top, bottom):
    """OBJ of a square from -1 to 1 with these coordinates at its edges; in a file, v runs up."""
    corners = [(-1, -1, left, 1 - bottom), (1, -1, right, 1 - bottom), (1, 1, right, 1 - top), (-1, 1, left, 1 - top)]
    return ("".join("v %g %g 0\nvt %.9g %.9g\n" % (x, y, u, v) for x, y, u, v in corners)
            + "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n")


def check(attempt):
    edges = -0.35, 0.55, -0.2, 0.6  # of the square, in coordinates
    (attempt.scratch / "board.obj").write_text(board(*edges))
    for picture in ("gradient.png", "checker.png"):
        scene = SCENE % picture
        eye, direction = rays(scene)
        point = eye + hit_plane(eye, direction, [0, 0, 1], [0, 0, 0])[..., None] * direction
        seen = np.abs(point).max(axis=-1) < 1
        across, down = (1 + point[..., 0]) / 2, (1 - point[..., 1]) / 2
        u = edges[0] + across * (edges[1] - edges[0])
        v = edges[2] + down * (edges[3] - edges[2])
        texels = texels_of(picture)
        half = np.concatenate([texels, texels[:, ::-1]], axis=1)
        tiles = np.concatenate([half, half[::-1]], axis=0)
        expected = np.where(seen[..., None], bilinear(tiles, REPEATS * u / 2, REPEATS * v / 2), 0)
        attempt.expect_same(attempt.render(*EXACT, scene=scene), expected, f"tiles of {picture}", strays=0.003)
