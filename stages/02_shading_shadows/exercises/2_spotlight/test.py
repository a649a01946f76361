# SPDX-License-Identifier: MIT
"""The course's picture of each light alone, times what the shade lets through: by the angle, from its sine too."""
import numpy as np
from exercises import closest, dot, lit_by, rays

SCENE = "02_shading_shadows.toml"
TARGET, FULL, EDGE = np.array([-0.2, 0.4, 0.4]), 0.16, 0.34
LOW = """
type = "point"
position = [-2.6, 1.5, 2.5]
color = [0.5, 0.8, 1]
intensity = 4
range = 5
"""


def shade(light, position):
    axis, way = TARGET - light, position - light
    angle = np.arctan2(np.linalg.norm(np.cross(axis, way), axis=-1), dot(axis, way))
    x = np.clip((np.cos(angle) - np.cos(EDGE)) / (np.cos(FULL) - np.cos(EDGE)), 0, 1)
    return (3 * x * x - 2 * x**3)[..., None]


def check(attempt):
    lamp, sky, low = (lit_by(SCENE, light) for light in (0, 1, LOW))
    eye, direction = rays(SCENE)
    distance, _, _ = closest(SCENE, eye, direction)
    position = eye + distance[..., None] * direction
    spot = shade(np.array([3.2, 4.6, 4.2]), position) * attempt.render(scene=lamp, original=True)
    attempt.expect_same(attempt.render(), spot + attempt.render(scene=sky, original=True), "the lamp with its shade")
    small = shade(np.array([-2.6, 1.5, 2.5]), position) * attempt.render(scene=low, original=True)
    attempt.expect_same(attempt.render(scene=low), small, "a lamp with a range, elsewhere")
