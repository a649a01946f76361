# SPDX-License-Identifier: MIT
"""Each ray is the forward direction, turned about an axis across it (Rodrigues' formula), whatever the fov."""
import numpy as np
from exercises import closest, expect, normals_and_distances, rays, scene_text, unit

SCENE = "01_primitives.toml"
EDGE = np.pi / 2


def turned(scene, size):
    """Eye and directions."""
    eye, middle = rays(scene, (1, 1))  # one pixel: its centre is the picture's
    _, wide = rays(scene, (3, 3))
    forward = middle[0, 0]
    right = unit(wide[1, 2] - wide[1, 0])
    up = np.cross(right, forward)
    width, height = size
    x = ((np.arange(width) + 0.5) * 2 / width - 1)[None, :]
    y = (height / width * (1 - (np.arange(height) + 0.5) * 2 / height))[:, None]
    angle = (EDGE * np.hypot(x, y))[..., None]
    around = np.arctan2(y, x)[..., None]
    axis = np.sin(around) * right - np.cos(around) * up  # across forward and the way to lean
    return eye, np.cos(angle) * forward + np.sin(angle) * np.cross(axis, forward)


def check(attempt):
    narrow = scene_text(SCENE).replace("fov = 60", "fov = 35").replace("[0, 0.7, 0]", "[0.5, 0, 1]")
    for scene, size in ((SCENE, (160, 96)), (narrow, (97, 99))):  # with a pixel in the very middle
        eye, direction = turned(scene, size)
        picture = attempt.render(scene=scene, size=size)
        distance, normal, _ = closest(scene, eye, direction)
        expected = normals_and_distances(scene, distance, normal)
        attempt.expect_same(picture, expected, "what the fisheye sees")
        middle = size[1] // 2, size[0] // 2
        expect(np.allclose(picture[middle], expected[middle], atol=2e-3),
               "the pixel in the middle is wrong: where a side has an odd number of them, what is divided by there?")
