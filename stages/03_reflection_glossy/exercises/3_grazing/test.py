# SPDX-License-Identifier: MIT
"""A ball alone reflects nothing but the sky: its share of that is Schlick's, at an angle known from geometry."""
import numpy as np
from exercises import closest, dot, rays

SKY = np.array([0.9, 0.7, 0.5])
COLOR, SPECULARITY = np.array([0.8, 0.5, 0.2]), 0.3


def ball(material, light=0):
    return f"""
[camera]
position = [0, 0.5, 3]
look_at = [0, 0, 0]
fov = 45
[background]
color = {list(SKY if not light else 0 * SKY)}
[materials.ball]
{material}
color = {list(COLOR)}
[[spheres]]
center = [0, 0, 0]
radius = 1
material = "ball"
[[lights]]
type = "directional"
direction = [-0.2, -0.5, -1]
intensity = {light}
"""


METAL = 'type = "mirror"'
VARNISH = f'type = "glossy"\nspecularity = {SPECULARITY}'


def check(attempt):
    scene = ball(METAL)
    eye, direction = rays(scene)
    distance, normal, _ = closest(scene, eye, direction)
    hit = np.isfinite(distance)[..., None]
    angle = np.arccos(np.clip(-dot(direction, normal), 0, 1))[..., None]
    rise = (2 * np.sin(angle / 2) ** 2) ** 5
    metal = COLOR + (1 - COLOR) * rise
    attempt.expect_same(attempt.render(scene=scene), np.where(hit, metal * SKY, SKY), "a ball of metal under the sky")
    varnish = SPECULARITY + (1 - SPECULARITY) * rise
    attempt.expect_same(attempt.render(scene=ball(VARNISH)), np.where(hit, varnish * SKY, SKY),
                        "a varnished ball under the sky")
    lit = ball(VARNISH, light=1)
    diffuse = attempt.render(scene=lit, original=True) / (1 - SPECULARITY)
    attempt.expect_same(attempt.render(scene=lit), np.where(hit, (1 - varnish) * diffuse, 0),
                        "what a varnished ball has from a light")
