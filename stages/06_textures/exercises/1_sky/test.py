# SPDX-License-Identifier: MIT
"""The picture unrolled around the eye, and once more around a mirror ball, where the reflected directions look."""
import numpy as np
from exercises import bilinear, closest, dot, rays, texels_of, unit

EXACT = "--method", "filtering=hand"  # whatever precision the device's own filter has
SCENE = """
[camera]
position = [0.5, 1, 4]
look_at = [%s]
fov = 100
[background]
color = [0.9, 0.2, 0.7]
[materials.picture]
type = "diffuse"
texture = "cube.png"
[materials.silver]
type = "mirror"
color = [0.9, 0.8, 0.7]
[[spheres]]
center = [0, 0, 30]
radius = 0.01
material = "picture"
[[spheres]]
center = [0, 1, 0]
radius = 1.5
material = "silver"
"""


def sky(direction):
    """Turned about the y axis: to the right, for one who looks along -z with y up, is x."""
    right, up, ahead = direction[..., 0], direction[..., 1], -direction[..., 2]
    longitude = np.angle(ahead + 1j * right)
    latitude = np.arctan2(up, np.hypot(right, ahead))
    return bilinear(texels_of("cube.png"), (longitude + np.pi) / (2 * np.pi), (np.pi / 2 - latitude) / np.pi)


def check(attempt):
    for look_at, what in (("0, 1, 0", "the sky and a mirror ball"), ("1, 1.5, 6", "the sky behind")):
        scene = SCENE % look_at
        eye, direction = rays(scene)
        distance, normal, _ = closest(scene, eye, direction)
        mirror = np.isfinite(distance)[..., None]
        reflected = direction - 2 * dot(direction, normal)[..., None] * normal
        expected = np.where(mirror, [0.9, 0.8, 0.7] * sky(unit(reflected)), sky(direction))
        attempt.expect_same(attempt.render(*EXACT, scene=scene), expected, what)
