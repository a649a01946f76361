# SPDX-License-Identifier: MIT
"""The picture is the one that the course's own kernels draw of a scene that has each mesh twice."""
import math

TURN, PLACE = math.degrees(math.acos(0.6)), (-1.9, 0.0, -1.5)
SCENE = """
[camera]
position = [1.2, 1.9, 4.5]
look_at = [-0.9, 0.3, -0.6]
fov = 55
[background]
color = [0.3, 0.4, 0.5]
[materials.clay]
type = "diffuse"
color = [0.86, 0.6, 0.42]
[materials.glaze]
type = "glossy"
color = [0.9, 0.9, 0.9]
specularity = 0.4
[[planes]]
normal = [0, 1, 0]
point = [0, -0.5, 0]
material = "glaze"
[[lights]]
type = "directional"
direction = [-0.4, -1, -0.7]
intensity = 0.6
[[lights]]
type = "point"
position = [2.5, 2, 2]
intensity = 6
"""


def mesh(file, size, x, y, z, turn):
    return f"""[[meshes]]
file = "{file}"
scale = {size}
position = [{x!r}, {y!r}, {z!r}]
rotation = [0, {turn!r}, 0]
material = "clay"
"""


def check(attempt):
    once = twice = SCENE
    meshes = ("cube.obj", 0.5, (0.2, 0.0, 0.3), 20), ("panel.obj", 0.4, (1.2, 0.1, 0.1), -30)
    for file, size, (x, y, z), turn in meshes:
        once += mesh(file, size, x, y, z, turn)
        cosine, sine = math.cos(math.radians(TURN)), math.sin(math.radians(TURN))
        there = cosine * x + sine * z + PLACE[0], y + PLACE[1], cosine * z - sine * x + PLACE[2]
        twice += mesh(file, size, x, y, z, turn) + mesh(file, size, *there, turn + TURN)
    attempt.expect_same(attempt.render(scene=once), attempt.render(scene=twice, original=True),
                        "a box and a square, twice each", tolerance=1e-3, strays=0.002)
