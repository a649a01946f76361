# SPDX-License-Identifier: MIT
"""Every pixel of a row is aimed at the edge between two triangles, and none may see what is behind. All else is as the
course draws it."""
import numpy as np
from exercises import expect, unit

PIXELS = 16384
SEEDS = 4, 25, 28  # of 70 tried, where Möller and Trumbore's way, or edges that were rounded, lose thousands of rays
SCENE = """
[camera]
position = [1.2, 1.9, 4.5]
look_at = [0, 0.3, 0]
fov = 55
[background]
color = [0.3, 0.4, 0.5]
[materials.clay]
type = "glossy"
color = [0.86, 0.6, 0.42]
specularity = 0.3
[[meshes]]
file = "materials.obj"
material = "clay"
scale = 0.8
[[planes]]
normal = [0, 1, 0]
point = [0, -0.01, 0]
[[lights]]
type = "point"
position = [2.5, 2, 2]
intensity = 6
"""


def aimed_at_an_edge(random, mesh):
    """Two triangles without light before a white background; their common edge is the picture's one row. Without
    random numbers it is seen straight on, so that the ray's side of it is exactly 0."""
    along, away = np.linalg.qr(random.normal(size=(3, 3)))[0][:2] if random else np.eye(3)[:2]
    middle = random.normal(size=3) / 2 if random else np.zeros(3)
    first, second = middle - 1.1 * along, middle + 0.9 * along
    eye = middle + 3 * np.cross(along, away) + (random.normal(size=3) / 3 if random else 0)
    corners = [first, second, middle + 1.3 * away, middle - 0.7 * away]
    mesh.write_text("".join("v %.9g %.9g %.9g\n" % tuple(corner) for corner in corners) + "f 1 2 3\nf 2 1 4\n")
    aim = (first + second) / 2
    up = np.cross(second - first, unit(aim - eye))
    return f"""
[camera]
position = {eye.tolist()}
look_at = {aim.tolist()}
up = {up.tolist()}
fov = 20
[background]
color = [1, 1, 1]
[[meshes]]
file = "{mesh.name}"
"""


def check(attempt):
    attempt.expect_same(attempt.render(scene=SCENE), attempt.render(scene=SCENE, original=True),
                        "a column and its mirror image", strays=0.003)
    for random in (None, *map(np.random.default_rng, SEEDS)):
        scene = aimed_at_an_edge(random, attempt.scratch / "mesh.obj")
        lost = (attempt.render(scene=scene, size=(PIXELS, 1)) > 0).any(axis=-1).sum()
        expect(lost == 0, f"{lost} of {PIXELS} rays that are aimed at an edge slip through between its two triangles")
