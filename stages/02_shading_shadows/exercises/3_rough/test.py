# SPDX-License-Identifier: MIT
"""The formula as it stands, by angles in a frame around each normal, on the course's picture of each light alone, which
has Lambert's cosine and the shadows."""
import numpy as np
from exercises import closest, dot, lit_by, rays, unit

SCENE = "02_shading_shadows.toml"
SIGMA = 0.6
AT_THE_EYE = """
type = "point"
position = [0.3, 2.3, 6.4]
intensity = 30
"""


def angles(normal, way):
    """Off the normal, and around it."""
    other = np.where(np.abs(normal[..., :1]) < 0.5, [1.0, 0, 0], [0, 1.0, 0])
    x = unit(np.cross(normal, other))
    y = np.cross(normal, x)
    return np.arccos(np.clip(dot(normal, way), -1, 1)), np.arctan2(dot(way, y), dot(way, x))


def rough(normal, to_light, to_eye):
    """As a multiple of the cosine."""
    square = SIGMA * SIGMA
    a, b = 1 - 0.5 * square / (square + 0.33), 0.45 * square / (square + 0.09)
    (theta_i, phi_i), (theta_r, phi_r) = angles(normal, to_light), angles(normal, to_eye)
    alpha, beta = np.maximum(theta_i, theta_r), np.minimum(theta_i, theta_r)
    return (a + b * np.maximum(0, np.cos(phi_i - phi_r)) * np.sin(alpha) * np.tan(beta))[..., None]


def check(attempt):
    eye, direction = rays(SCENE)
    distance, normal, _ = closest(SCENE, eye, direction)
    position = eye + distance[..., None] * direction
    sky = np.broadcast_to(unit(-np.array([0.7, -1, -0.75])), normal.shape)
    lamp = unit(np.array([0.3, 2.3, 6.4]) - position)
    for light, to_light, what in ((AT_THE_EYE, lamp, "lit by a lamp at the eye"), (1, sky, "in directional light")):
        scene = lit_by(SCENE, light)
        expected = rough(normal, to_light, -direction) * attempt.render(scene=scene, original=True)
        attempt.expect_same(attempt.render(scene=scene), expected, what)
