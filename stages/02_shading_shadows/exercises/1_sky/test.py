# SPDX-License-Identifier: MIT
"""What a surface gets, summed over directions: they are drawn as points of a disk beneath the hemisphere, which are as
dense as the cosine asks for (Malley's way)."""
import numpy as np
from exercises import closest, rays, reflectance

SCENE = "02_shading_shadows.toml"
SKY, GROUND = np.array([0.22, 0.3, 0.42]), np.array([0.16, 0.12, 0.08])


def share_of_sky(cosine):
    """Of all that a surface gets whose normal has this cosine with straight up."""
    side = (np.arange(400) + 0.5) / 200 - 1
    x, z = np.meshgrid(side, side)
    within = x * x + z * z < 1
    x = x[within]
    along = np.sqrt(1 - x * x - z[within] ** 2)
    sine = np.sqrt(1 - cosine * cosine)
    return np.mean(sine * x + cosine * along > 0)


def check(attempt):
    eye, direction = rays(SCENE)
    _, normal, index = closest(SCENE, eye, direction)
    cosines = np.linspace(-1, 1, 201)
    share = np.interp(normal[..., 1], cosines, [share_of_sky(c) for c in cosines])[..., None]
    expected = attempt.render(original=True) + reflectance(SCENE, index) * (share * SKY + (1 - share) * GROUND)
    attempt.expect_same(attempt.render(), expected, "with the light of sky and ground")
