# SPDX-License-Identifier: MIT
"""Wire is where the point that is hit is near the segment between two corners, in space: no barycentric
coordinates."""
import numpy as np
from exercises import ROOT, dot, hit_triangles, rays, triangles_of

WIDTH, COLOR = 0.003, np.array([0.05, 0.1, 0.2])
SCALE = np.array([0.06, 0.045, 0.03])
SCENE = f"""
[camera]
position = [0.1, 0.13, 0.17]
look_at = [0, 0.01, 0]
fov = 55
[background]
color = [1, 1, 1]
[materials.white]
type = "diffuse"
[[meshes]]
file = "cube.obj"
scale = {SCALE.tolist()}
material = "white"
[[planes]]
normal = [0, 1, 0]
point = [0, -0.045, 0]
[[lights]]
type = "directional"
direction = [-0.5, -1, -0.8]
"""


def from_segment(point, start, end):
    along = end - start
    share = np.clip(dot(point - start, along) / dot(along, along), 0, 1)
    return np.linalg.norm(point - start - share[..., None] * along, axis=-1)


def check(attempt):
    corners = SCALE * triangles_of((ROOT / "scenes/cube.obj").read_text())[0]
    eye, direction = rays(SCENE)
    distance, index, _ = hit_triangles(eye, direction, corners)
    seen = np.isfinite(distance)
    point = eye + np.where(seen, distance, 0)[..., None] * direction
    a, b, c = np.moveaxis(corners[index], -2, 0)
    wire = seen & (np.minimum.reduce([from_segment(point, *edge) for edge in ((a, b), (b, c), (c, a))]) < WIDTH)
    plain = attempt.render("--depth", 0, scene=SCENE, original=True)
    expected = np.where(wire[..., None], plain * COLOR, plain)
    attempt.expect_same(attempt.render("--depth", 0, scene=SCENE), expected, "edges on a box", strays=0.003)
