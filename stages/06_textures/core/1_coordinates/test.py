# SPDX-License-Identifier: MIT
"""A sphere from the front, from behind and from above: longitude and latitude in double."""
import numpy as np
from exercises import bilinear, closest, light_at, rays, texels_of

EYE = """
[camera]
position = [%s]
look_at = [0, 0, 0]
fov = 50
[background]
color = [0.1, 0.2, 0.3]
[materials.picture]
type = "diffuse"
texture = "gradient.png"
[[spheres]]
center = [0, 0, 0]
radius = 1
material = "picture"
[[lights]]
type = "directional"
direction = [%s]
"""
FRONT = EYE % ("0.6, 0.5, 2.9", "-0.5, -0.3, -1")
BACK = EYE % ("0.4, 0.3, -2.9", "-0.3, -0.3, 1")
POLE = EYE % ("0.3, 2.9, 0.3", "-0.3, -1, -0.2")
GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, -1, 0]
"""


def expected(scene):
    """What a sphere around the world's origin shows of its picture, in light."""
    eye, direction = rays(scene)
    distance, normal, index = closest(scene, eye, direction)
    q = np.where(index[..., None] == 0, normal, [0.0, 0, 1])
    u = 0.5 + np.arctan2(q[..., 0], q[..., 2]) / (2 * np.pi)
    v = 0.5 - np.arcsin(np.clip(q[..., 1], -1, 1)) / np.pi
    color = np.where(index[..., None] == 0, bilinear(texels_of("gradient.png"), u, v), 1)
    seen = np.isfinite(distance)
    color[seen] *= light_at(scene, (eye + np.where(seen, distance, 0)[..., None] * direction)[seen], normal[seen])
    return np.where(seen[..., None], color, [0.1, 0.2, 0.3])


LATITUDE = "asin(clamp(normal.y, (float)(-1.0f), (float)(1.0f))) / PI"
MISTAKES = [
    ("atan2(normal.x, normal.z)", "atan2(normal.z, normal.x)",
     "The picture is mirrored and turned by a quarter: x is the first argument of atan2 and z the second."),
    ("0.5f + atan2", "atan2",
     "The picture's middle is at the back: 0.5 is missing in u."),
    ("(2.0f * PI)", "PI",
     "The picture is there twice around: a full turn is 2π."),
    ("0.5f - asin", "0.5f + asin",
     "The picture is upside down: v goes down from the north pole."),
    (LATITUDE, LATITUDE.replace("PI", "(2.0f * PI)"),
     "Only the middle of the picture is there, from pole to pole: half a turn is π."),
    ("atan2(normal.x, normal.z)", "atan2(-normal.x, normal.z)",
     "The picture is mirrored: u grows to the right, as seen from outside."),
    (LATITUDE, "0.5f * normal.y",
     "The picture is stretched near the poles: the latitude is an angle, the asin of y."),
    ("atan2(normal.x, normal.z)", "atan2(normal.x, normal.y)",
     "The picture turns about the wrong axis: y is up, so the longitude is that of x and z."),
]


def check(attempt):
    for scene, what in ((FRONT, "the front of a sphere"), (BACK + GROUND, "its back, where the edges of the picture meet"),
                        (POLE, "its north pole")):
        attempt.expect_same(attempt.render(scene=scene), expected(scene), what)
