# SPDX-License-Identifier: MIT
"""The solids by sphere tracing (Hart, The Visual Computer 12, 1996): no interval and no root, but steps as long as no
wall can be nearer; normals by differences."""
import tomllib

import numpy as np
from exercises import dot, hit_plane, normals_and_distances, rays, scene_text, unit

TOWARDS, SHARE = np.array([0.48, 0.6, 0.64]), 0.7
IN_THE_BODY = """
camera = { position = [-0.3, -0.2, -0.1], look_at = [0.5, 0.4, 0.7], fov = 140 }
spheres = [{ center = [0, 0, 0], radius = 1 }]
"""
IN_THE_HOLLOW = """
camera = { position = [0.7, 0.8, 0.9], look_at = [-0.3, -0.1, -0.2], fov = 120 }
spheres = [{ center = [0, 0, 0], radius = 1 }]
"""


def outside(spheres, point):
    """At least so far off the nearest wall; below zero within a solid."""
    nearest = np.full(point.shape[:-1], np.inf)
    for sphere in spheres:
        center, radius = np.array(sphere["center"], float), sphere["radius"]
        bite = center + radius * TOWARDS
        of_body = np.linalg.norm(point - center, axis=-1) - radius
        of_bite = SHARE * radius - np.linalg.norm(point - bite, axis=-1)
        nearest = np.minimum(nearest, np.maximum(of_body, of_bite))
    return nearest


def traced(spheres, eye, direction):
    """Distance, inf for none, and normal."""
    t = np.zeros(direction.shape[:-1])
    going = np.ones(t.shape, bool)
    for _ in range(300):
        step = np.abs(outside(spheres, eye + t[going][:, None] * direction[going]))
        t[going] += step
        going[going] = (step > 1e-7) & (t[going] < 50)
    point = eye + t[..., None] * direction
    slope = [outside(spheres, point + 1e-5 * axis) - outside(spheres, point - 1e-5 * axis) for axis in np.eye(3)]
    normal = unit(np.stack(slope, axis=-1))
    normal = np.where(dot(normal, direction)[..., None] > 0, -normal, normal)
    return np.where(t < 50, t, np.inf), normal


def expected(scene):
    described = tomllib.loads(scene_text(scene))
    eye, direction = rays(scene)
    distance, normal = traced(described["spheres"], eye, direction)
    for plane in described.get("planes", []):
        t = hit_plane(eye, direction, plane["normal"], plane["point"])
        n = unit(np.array(plane["normal"], float))
        nearer = t < distance
        distance[nearer] = t[nearer]
        normal[nearer] = np.where(dot(n, direction)[..., None] > 0, -n, n)[nearer]
    return normals_and_distances(scene, distance, normal)


def check(attempt):
    for scene, what in (("01_primitives.toml", "the spheres with their bites"),
                        (IN_THE_BODY, "from inside a body"), (IN_THE_HOLLOW, "from the hollow of a bite")):
        attempt.expect_same(attempt.render(scene=scene), expected(scene), what)
