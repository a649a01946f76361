# SPDX-License-Identifier: MIT
"""Every pixel of a row is aimed at the edge between two triangles, and none may see what is behind. All else is as the
course draws it."""
import numpy as np
from exercises import expect, unit

PIXELS = 16384
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
    """A scene of two triangles, white before black, whose common edge is the picture's one row. From all but 1 in 100
    of these eyes the textbook's formulas lose rays, or from few."""
    along, away = np.linalg.qr(random.normal(size=(3, 3)))[0][:2]
    middle = random.normal(size=3) / 2
    first, second = middle - 1.1 * along, middle + 0.9 * along
    eye = middle + 3 * np.cross(along, away) + random.normal(size=3) / 3
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
    expect(True, "")
