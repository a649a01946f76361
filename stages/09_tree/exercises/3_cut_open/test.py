# SPDX-License-Identifier: MIT
"""A box and three balls on a floor, cut by a plane: what is left of them, in a point light and a directional one. Balls by
the quadratic equation, triangles by their three equations, in double."""
import numpy as np
from exercises import ROOT, dot, expect, hit_plane, hit_sphere, hit_triangles, rays, triangles_of, unit

NORMAL, OFFSET = np.array([-0.28, 0, 0.96]), 0.1
BALLS = [((-1.6, 0.1, 0.2), 0.7), ((1.9, 0.0, 0.6), 0.8), ((0.2, 1.7, -0.5), 0.5)]
BOX, SCALE = np.array([0.1, -0.2, 0.05]), 0.6
FLOOR = [0, 1, 0], [0, -0.8, 0]
POINT, INTENSITY = np.array([-2.0, 3.0, 4.0]), 14.0
TOWARDS, SUN = unit(np.array([0.4, 1, 0.9])), 0.5
SCENE = f"""
[camera]
position = [0.3, 1.6, 5]
look_at = [0.1, 0.2, 0]
fov = 52
[background]
color = [0, 0, 0]
[materials.white]
type = "diffuse"
[[planes]]
normal = [0, 1, 0]
point = [0, -0.8, 0]
material = "white"
[[meshes]]
file = "cube.obj"
position = {BOX.tolist()}
scale = {SCALE}
material = "white"
[[lights]]
type = "point"
position = {POINT.tolist()}
intensity = {INTENSITY}
[[lights]]
type = "directional"
direction = {(-TOWARDS).tolist()}
intensity = {SUN}
""" + "".join(f"""
[[spheres]]
center = {list(center)}
radius = {radius}
material = "white"
""" for center, radius in BALLS)


def still_there(origin, direction, distance):
    point = origin + np.where(np.isfinite(distance), distance, 0)[..., None] * direction
    return np.where(dot(point, NORMAL) <= OFFSET, distance, np.inf)


def hits(origin, direction):
    """Distances along the directions, of any length, and normals."""
    found = []
    for center, radius in BALLS:
        length = np.linalg.norm(direction, axis=-1)
        along = unit(direction)
        # The far wall is the near one of a ray that comes back from beyond.
        near = hit_sphere(origin, along, center, radius)
        far = 100 - hit_sphere(origin + 100 * along, -along, center, radius)
        walls = [still_there(origin, along, np.where(wall > 1e-6, wall, np.inf)) for wall in (near, far)]
        t = np.minimum(*walls)
        point = origin + np.where(np.isfinite(t), t, 0)[..., None] * along
        found.append((t / length, unit(point - np.array(center))))
    for corners in BOX + SCALE * triangles_of((ROOT / "scenes/cube.obj").read_text())[0]:
        t, _, _ = hit_triangles(origin, direction, corners[None])
        normal = unit(np.cross(corners[1] - corners[0], corners[2] - corners[0]))
        found.append((still_there(origin, direction, t), np.broadcast_to(normal, direction.shape)))
    floor = hit_plane(origin, direction, *FLOOR)
    found.append((floor, np.broadcast_to(np.array([0.0, 1, 0]), direction.shape)))
    distances = np.stack([distance for distance, _ in found])
    which = distances.argmin(axis=0)
    normals = np.take_along_axis(np.stack([normal for _, normal in found]), which[None, ..., None], axis=0)[0]
    return distances.min(axis=0), np.where(dot(normals, direction)[..., None] > 0, -normals, normals)


def check(attempt):
    eye, direction = rays(SCENE)
    distance, normal = hits(eye, direction)
    seen = np.isfinite(distance)
    point = eye + np.where(seen, distance, 1)[..., None] * direction + 1e-5 * normal
    to_light = POINT - point
    light = np.maximum(dot(normal, to_light), 0) / dot(to_light, to_light)**1.5 * INTENSITY * (hits(point, to_light)[0] > 1)
    towards = np.broadcast_to(TOWARDS, point.shape)
    sun = np.maximum(dot(normal, TOWARDS), 0) * SUN * ~np.isfinite(hits(point, towards)[0])
    expected = np.where(seen, light + sun, 0)[..., None] * np.ones(3)
    expect(seen.mean() > 0.5, "the test's picture is too empty")
    attempt.expect_same(attempt.render(scene=SCENE), expected, "a box and three balls, cut", strays=0.02)
