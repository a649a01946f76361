# SPDX-License-Identifier: MIT
"""Bowls on a floor, seen from above and from below their rims, in a point light and a directional one: both walls by the quadratic equation, in
double, and of these what is not above the centre."""
import numpy as np
from exercises import dot, expect, rays, unit

BOWLS = [((-1.7, 0.3, 0.4), 0.9), ((0.5, 1.0, -1.1), 1.1), ((1.6, -0.1, 0.9), 0.7), ((0.0, 2.6, 0.3), 0.6)]
FLOOR = -1.0
POINT, INTENSITY = np.array([-1.2, 4.0, 2.4]), 14.0
TOWARDS, SUN = unit(np.array([0.5, 1, 0.35])), 0.5
SKY = np.array([0.1, 0.2, 0.4])
SCENE = f"""
[camera]
position = [0.4, 1.9, 6.5]
look_at = [0.1, 0.5, 0]
fov = 48
[background]
color = {list(SKY)}
[materials.white]
type = "diffuse"
[[planes]]
normal = [0, 1, 0]
point = [0, {FLOOR}, 0]
material = "white"
[[lights]]
type = "point"
position = {list(POINT)}
intensity = {INTENSITY}
[[lights]]
type = "directional"
direction = {list(-TOWARDS)}
intensity = {SUN}
""" + "".join(f"""
[[spheres]]
center = {list(center)}
radius = {radius}
material = "white"
""" for center, radius in BOWLS)


def walls(origin, direction):
    """For each bowl, then the floor: after how many lengths of the direction it is met, inf where it is not."""
    met = []
    for center, radius in BOWLS:
        a, b = dot(direction, direction), dot(origin - np.array(center), direction)
        with np.errstate(invalid="ignore"):
            root = np.sqrt(b * b - a * (dot(origin - np.array(center), origin - np.array(center)) - radius * radius))
        bowl = np.full(b.shape, np.inf)
        for t in ((-b + root) / a, (-b - root) / a):  # the nearer one last
            height = origin[..., 1] + t * direction[..., 1]
            bowl = np.where((t > 1e-6) & (height <= center[1]), t, bowl)
        met.append(bowl)
    t = (FLOOR - origin[..., 1]) / direction[..., 1]
    return np.stack(met + [np.where(t > 1e-6, t, np.inf)])


def check(attempt):
    eye, direction = rays(SCENE)
    met = walls(eye, direction)
    which, distance = met.argmin(axis=0), met.min(axis=0)
    seen = np.isfinite(distance)
    point = eye + np.where(seen, distance, 1)[..., None] * direction
    centers = np.array([center for center, _ in BOWLS] + [(0, 0, 0)])
    normal = np.where((which == len(BOWLS))[..., None], [0.0, 1, 0], unit(point - centers[which]))
    normal = np.where(dot(normal, direction)[..., None] > 0, -normal, normal)
    start = point + 1e-6 * normal
    to_light = POINT - start
    light = np.maximum(dot(normal, to_light), 0) / dot(to_light, to_light)**1.5 * INTENSITY * (walls(start, to_light) > 1).all(axis=0)
    towards = np.broadcast_to(TOWARDS, start.shape)
    sun = np.maximum(dot(normal, TOWARDS), 0) * SUN * ~np.isfinite(walls(start, towards)).any(axis=0)
    expected = np.where(seen[..., None], (light + sun)[..., None], SKY)
    expect((which < len(BOWLS)).mean() > 0.1, "the bowls fill too little of the test's picture")
    for width in (16, 4):
        picture = attempt.render("--method", f"width={width}", scene=SCENE)
        attempt.expect_same(picture, expected, f"four bowls, {width} rays at a time")
