# SPDX-License-Identifier: MIT
"""The share of the lamp that is seen, by a fine grid on it; a sphere is in the way where the line passes its centre
nearer than its radius. The scene is one large penumbra."""
import numpy as np
from exercises import closest, dot, expect, lit_by, rays, unit

SCENE = "02_shading_shadows.toml"
RADIUS = 0.7
LAMP = np.array([2.0, 2.2, 0.8])
BALL, BALL_RADIUS = np.array([0.2, 1.0, 0.0]), 0.5
PENUMBRA = """
camera = { position = [-1.5, 4, 1.5], look_at = [-1.5, 0, 0], fov = 60 }
materials.white = { type = "diffuse" }
planes = [{ normal = [0, 1, 0], point = [0, 0, 0], material = "white" }]
spheres = [{ center = [0.2, 1, 0], radius = 0.5, material = "white" }]
lights = [{ type = "point", position = [2, 2.2, 0.8], intensity = 10 }]
"""


def share_seen(position, to_lamp, rings=16, around=48):
    """Rings of the same area, each of points side by side."""
    right = unit(np.cross(to_lamp, [0.0, 1.0, 0.0]))
    up = np.cross(right, to_lamp)
    seen = np.zeros(to_lamp.shape[:-1])
    for radius in RADIUS * np.sqrt((np.arange(rings) + 0.5) / rings):
        for angle in 2 * np.pi * np.arange(around) / around:
            way = LAMP + radius * (np.cos(angle) * right + np.sin(angle) * up) - position
            along = np.clip(dot(BALL - position, way) / dot(way, way), 0, 1)[..., None]
            seen += np.linalg.norm(BALL - position - along * way, axis=-1) > BALL_RADIUS
    return seen / (rings * around)


def check(attempt):
    eye, direction = rays(PENUMBRA)
    distance, normal, _ = closest(PENUMBRA, eye, direction)
    position = eye + distance[..., None] * direction
    way = LAMP - position
    to_lamp = unit(way)
    unhidden = (np.maximum(dot(normal, to_lamp), 0) * 10 / dot(way, way))[..., None]
    share = share_seen(position + 1e-5 * normal, to_lamp)[..., None]
    lit = unhidden > 0.01
    found = np.where(lit, attempt.render(scene=PENUMBRA) / np.where(lit, unhidden, 1), 0)
    right = np.where(lit, share, 0) * np.ones(3)
    attempt.expect_same(found, right, "the share of the lamp that is seen", tolerance=0.045)
    off = (found - right)[(right > 0) & (right < 1)]
    expect(np.sqrt(np.mean(off**2)) < 0.018 and abs(off.mean()) < 0.002,
           f"in the penumbra the share is off by {np.sqrt(np.mean(off**2)):.3f}, and by {off.mean():.4f} on average: "
           "is each part of the disk of the same weight, and are there enough points?")
    both, lamp, sky = lit_by(SCENE, 0, 1), lit_by(SCENE, 0), lit_by(SCENE, 1)
    attempt.expect_same(attempt.render(scene=both),
                        attempt.render(scene=lamp) + attempt.render(scene=sky, original=True),
                        "with a directional light, whose shadows stay as they were", tolerance=1e-4)
