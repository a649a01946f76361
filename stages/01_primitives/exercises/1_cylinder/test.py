# SPDX-License-Identifier: MIT
"""The tube is where a march along each ray first crosses the wall: no quadratic equation."""
import numpy as np
from exercises import closest, dot, normals_and_distances, rays, unit

SCENE = "01_primitives.toml"
BASE, HEIGHT, RADIUS = np.array([0.9, 0, 0.6]), 1.6, 0.5


def tube(eye, direction):
    """Distance, by steps and bisection."""
    def outside(t):
        point = eye + t[..., None] * direction - BASE
        return np.hypot(point[..., 0], point[..., 2]) - RADIUS

    steps = np.linspace(0, 20, 2001)
    found = np.full(direction.shape[:-1], np.inf)
    for near, far in zip(steps, steps[1:]):
        low, high = (np.full(found.shape, t) for t in (near, far))
        crossed = np.sign(outside(low)) != np.sign(outside(high))
        if not (crossed & ~np.isfinite(found)).any():
            continue
        sign = np.sign(outside(low))
        for _ in range(40):
            middle = (low + high) / 2
            before = np.sign(outside(middle)) == sign
            low, high = np.where(before, middle, low), np.where(before, high, middle)
        height = eye[1] + high * direction[..., 1] - BASE[1]
        hit = crossed & ~np.isfinite(found) & (height >= 0) & (height <= HEIGHT)
        found[hit] = high[hit]
    return found


def check(attempt):
    eye, direction = rays(SCENE)
    distance, normal, _ = closest(SCENE, eye, direction)
    wall = tube(eye, direction)
    first = np.where(np.isfinite(wall), wall, 0)[..., None] * direction + eye - BASE
    outward = unit(first * [1, 0, 1])
    inward = dot(outward, direction)[..., None] > 0
    nearer = wall < distance
    normal = np.where(nearer[..., None], np.where(inward, -outward, outward), normal)
    expected = normals_and_distances(SCENE, np.minimum(distance, wall), normal)
    attempt.expect_same(attempt.render(), expected, "the tube among the spheres")
