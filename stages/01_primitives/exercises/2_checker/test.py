# SPDX-License-Identifier: MIT
"""The cubes by waves: the product of three sines, one along each axis, changes its sign at each face."""
import numpy as np
from exercises import closest, rays

SCENE = "01_primitives.toml"
SIZE, CORNER, DARK = 0.5, np.array([0, 0.25, 0]), 0.35


def check(attempt):
    eye, direction = rays(SCENE)
    distance, _, _ = closest(SCENE, eye, direction)
    seen = np.isfinite(distance)
    position = eye + np.where(seen, distance, 0)[..., None] * direction
    waves = np.prod(np.sin(np.pi * (position - CORNER) / SIZE), axis=-1)
    shade = np.where(seen & (waves < 0), DARK, 1)
    expected = shade[..., None] * attempt.render(original=True)
    attempt.expect_same(attempt.render(), expected, "every second cube dark", tolerance=2e-4)
