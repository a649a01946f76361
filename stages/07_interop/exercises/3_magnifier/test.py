# SPDX-License-Identifier: MIT
"""Within the lens is the middle of a picture of three times the size, pixel for pixel; around it nothing has changed. With
several samples each pixel is the mean of such."""
import numpy as np
from exercises import expect

SCENE = "03_reflection_glossy.toml"
RADIUS, POWER = 30, 3
WIDTH, HEIGHT = 160, 96


def check(attempt):
    course = attempt.render(scene=SCENE, original=True)
    large = attempt.render(scene=SCENE, size=(POWER * WIDTH, POWER * HEIGHT), original=True)
    top, left = (POWER - 1) * HEIGHT // 2, (POWER - 1) * WIDTH // 2
    middle = large[top:top + HEIGHT, left:left + WIDTH]
    x, y = np.meshgrid(np.arange(WIDTH) + 0.5 - WIDTH / 2, np.arange(HEIGHT) + 0.5 - HEIGHT / 2)
    within = (np.hypot(x, y) < RADIUS)[..., None]
    attempt.expect_same(attempt.render(scene=SCENE), np.where(within, middle, course), "the lens", tolerance=2e-3,
                        strays=0.002)
    # Of samples, those of the rim are partly within.
    smooth = attempt.render("--samples", 16, scene=SCENE, size=(POWER * WIDTH, POWER * HEIGHT), original=True)
    around = attempt.render("--samples", 16, scene=SCENE, original=True)
    expected = np.where(within, smooth[top:top + HEIGHT, left:left + WIDTH], around)
    rim = abs(np.hypot(x, y) - RADIUS) < 1
    drawn = attempt.render("--samples", 16, scene=SCENE)
    inner, outer = smooth[top:top + HEIGHT, left:left + WIDTH][rim], around[rim]
    apart = np.abs(inner - outer).min(axis=-1) > 0.02
    mixed = (np.abs(drawn[rim] - inner).min(axis=-1) > 0.002) & (np.abs(drawn[rim] - outer).min(axis=-1) > 0.002)
    expect(mixed[apart].mean() > 0.3, "with 16 samples, the lens's rim should mix what is within and without")
    drawn[rim] = expected[rim]
    attempt.expect_same(drawn, expected, "the lens with 16 samples", tolerance=2e-3, strays=0.004)
