# SPDX-License-Identifier: MIT
"""A mirror on a wall shows the horizon, far away. The share of sky in a bundle is the part of the disc above a
straight line: a circle's segment, in closed form."""
import json
import numpy as np
from exercises import expect, rays, unit

SKY, GROUND = np.array([0.9, 0.5, 0.1]), np.array([0.1, 0.2, 0.6])
ROUGHNESS, RAYS = 0.12, 32


def wall(sky, ground, turned=np.eye(3)):
    """A mirror before the eye, a floor that is equally bright everywhere, a sky; all of it turned."""
    def vector(*v):
        return list(turned @ v)
    return f"""
[camera]
position = {vector(0.3, 1, 0)}
look_at = {vector(0.2, 1.05, -3)}
up = {vector(0, 1, 0)}
fov = 50
[background]
color = {list(sky)}
[materials.mirror]
type = "mirror"
[materials.ground]
type = "diffuse"
color = {list(ground)}
[[planes]]
normal = {vector(0, 0, 1)}
point = {vector(0, 0, -3)}
material = "mirror"
[[planes]]
normal = {vector(0, 1, 0)}
point = [0, 0, 0]
material = "ground"
[[lights]]
type = "directional"
direction = {vector(0, -1, -1e-4)}
"""


def about(axis, degrees):
    """The rotation about an axis (Rodrigues)."""
    x, y, z = unit(np.array(axis, float))
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    a = np.radians(degrees)
    return np.eye(3) + np.sin(a) * k + (1 - np.cos(a)) * k @ k


def above(height):
    """The part of a unit disc that lies above a line at the height -height."""
    h = np.clip(height, -1, 1)
    return 0.5 + (np.arcsin(h) + h * np.sqrt(1 - h * h)) / np.pi


def check(attempt):
    stats = attempt.scratch / "stats.json"
    mirrors = wall([1, 1, 1], [1, 1, 1]).replace('type = "diffuse"', 'type = "mirror"')
    white = attempt.render("--stats", stats, scene=mirrors)
    expect(np.abs(white - 1).max() < 1e-4, "between white mirrors under a white sky all must be white: it "
           f"is {white.min():.4g} to {white.max():.4g}; are all rays there, each with its part of the weight?")
    reflected = json.loads(stats.read_text())["rays"]["reflection"] / white[..., 0].size
    expect(RAYS <= reflected <= 2 * RAYS, f"a pixel has {reflected:.4g} reflected rays: expected {RAYS} at the first "
           "mirror, and one for each of them that meets the second")
    scene = wall(SKY, GROUND)
    eye, direction = rays(scene)
    to_wall = eye[1] - 3 * direction[..., 1] / direction[..., 2]
    rise = direction[..., 1]  # the wall turns z alone
    sky = above(rise / (ROUGHNESS * np.sqrt(1 - rise * rise)))[..., None]
    expected = np.where((to_wall > 0)[..., None], sky * SKY + (1 - sky) * GROUND, GROUND)
    # However the room lies in space, it looks the same.
    for turned in (np.eye(3), about((0, 1, 0), 60) @ about((0, 0, 1), 45)):
        picture = attempt.render(scene=wall(SKY, GROUND, turned))
        # 32 points fill a segment right to some hundredths.
        attempt.expect_same(picture, expected, "the horizon in the mirror", tolerance=0.07, strays=0)
        bias = np.abs((picture - expected).mean(axis=(0, 1))).max()
        expect(bias < 0.005, f"in the mean the horizon is off by {bias:.2g}: the bundle leans to one side")
