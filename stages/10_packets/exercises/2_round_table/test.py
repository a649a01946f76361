# SPDX-License-Identifier: MIT
"""A white disc, and above it two tilted ones, in a point light and a directional one: where rays cross the planes, and whether
lines to the lights cross one, by the planes' equations in double."""
import numpy as np
from exercises import dot, expect, rays, unit

RADIUS = 1.6
NORMALS = unit(np.array([[0, 1, 0], [0.35, 1, 0.2], [-0.6, 1, 0.15]], float))
OFFSETS = np.array([-1.0, 0.4, 1.5])
POINT, INTENSITY = np.array([1.1, 5.0, 0.7]), 12.0
TOWARDS, SUN = unit(np.array([-0.5, 1, 0.3])), 0.5
SKY = np.array([0.1, 0.2, 0.4])
SCENE = f"""
[camera]
position = [0.6, 2.2, 7.5]
look_at = [0, 0, 0]
fov = 46
[background]
color = {list(SKY)}
[materials.white]
type = "diffuse"
[[lights]]
type = "point"
position = {list(POINT)}
intensity = {INTENSITY}
[[lights]]
type = "directional"
direction = {list(-TOWARDS)}
intensity = {SUN}
""" + "".join(f"""
[[planes]]
normal = {list(normal)}
point = {list(offset * normal)}
material = "white"
""" for normal, offset in zip(NORMALS, OFFSETS))


def crossings(origin, direction):
    """For each disc: after how many lengths of the direction it is met, inf where it is not."""
    t = np.stack([(offset - dot(origin, normal)) / dot(direction, normal) for normal, offset in zip(NORMALS, OFFSETS)])
    point = origin + t[..., None] * direction
    middle = (NORMALS * OFFSETS[:, None])[:, None, None]
    return np.where((t > 1e-6) & (np.linalg.norm(point - middle, axis=-1) <= RADIUS), t, np.inf)


def check(attempt):
    eye, direction = rays(SCENE)
    met = crossings(eye, direction)
    which, distance = met.argmin(axis=0), met.min(axis=0)
    seen = np.isfinite(distance)
    point = eye + np.where(seen, distance, 1)[..., None] * direction
    normal = NORMALS[which]
    normal = np.where(dot(normal, direction)[..., None] > 0, -normal, normal)
    to_light = POINT - point
    squared = dot(to_light, to_light)
    light = np.maximum(dot(normal, to_light), 0) / squared**1.5 * INTENSITY * (crossings(point, to_light) > 1).all(axis=0)
    sun = np.maximum(dot(normal, TOWARDS), 0) * SUN * ~np.isfinite(crossings(point, np.broadcast_to(TOWARDS, point.shape))).any(axis=0)
    expected = np.where(seen[..., None], (light + sun)[..., None], SKY)
    expect(0.2 < seen.mean() < 0.8, "the discs fill too much or too little of the test's picture")
    for width in (16, 4):
        picture = attempt.render("--method", f"width={width}", scene=SCENE)
        attempt.expect_same(picture, expected, f"three discs, {width} rays at a time")
