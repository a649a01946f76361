# SPDX-License-Identifier: MIT
"""Only five codes are there, and the mean light of each block of pixels is what it was: measured on a wall whose light
changes slowly, and on even walls."""
import numpy as np
from exercises import expect

CODES = np.arange(5) / 4
LIGHTS = np.where(CODES <= 0.04045, CODES / 12.92, ((CODES + 0.055) / 1.055) ** 2.4)
WALL = """
[camera]
position = [0, 0, 3]
look_at = [0, 0, 0]
[[planes]]
normal = [0, 0, 1]
point = [0, 0, 0]
[[lights]]
type = {}
"""
LAMP = WALL.format('"point"\nposition = [-2, 1, 2]\ncolor = [1, 0.7, 0.4]\nintensity = 4')


def blocks(picture):
    """The mean of each block of 8 by 8 pixels."""
    height, width, _ = picture.shape
    return picture.reshape(height // 8, 8, width // 8, 8, 3).mean(axis=(1, 3))


def check(attempt):
    drawn = attempt.render(scene=LAMP)
    off = np.abs(drawn[..., None] - LIGHTS).min(axis=-1).max()
    expect(off < 1e-5, f"a pixel shows light that is {off:.3g} off the nearest of the five codes'")
    light = attempt.render(scene=LAMP, original=True)
    error = np.abs(blocks(drawn) - blocks(np.minimum(light, 1))).max()
    expect(error < 0.03, f"the mean light of a block of 8 by 8 pixels is off by {error:.3g}: expected less than 0.03")
    for level in (0.02, 0.13, 0.35, 0.7, 0.95):
        wall = WALL.format(f'"directional"\ndirection = [0, 0, -1]\nintensity = {level}')
        mean = blocks(attempt.render(scene=wall, size=(16, 16))).mean()
        step = np.diff(LIGHTS)[np.searchsorted(LIGHTS, level) - 1]
        expect(abs(mean - level) < 0.51 / 64 * step + 1e-4,
               f"an even wall of light {level} gives {mean:.4f} in the mean of its pixels")
