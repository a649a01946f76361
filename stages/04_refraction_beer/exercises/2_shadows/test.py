# SPDX-License-Identifier: MIT
"""The way inside each ball is added up in small steps along each shadow ray: no root is taken."""
import numpy as np
import tomllib
from exercises import closest, dot, rays, unit

SIZE = (80, 48)
STEPS = 2000
FLOOR = np.array([0.9, 0.8, 0.7])

# Seen from above. A lamp shines through one ball, and from within another; a third is behind it, a fourth beneath
# the floor. One is of stone.
ROOM = f"""
[camera]
position = [0, 9, 0.1]
look_at = [0, 0, 0]
fov = 50
[materials.floor]
type = "diffuse"
color = {list(FLOOR)}
[materials.red]
type = "dielectric"
ior = 1.5
absorption = [0.1, 0.9, 1.5]
[materials.green]
type = "dielectric"
ior = 1.3
absorption = [0.8, 0.1, 0.5]
[materials.stone]
type = "diffuse"
color = [0.5, 0.5, 0.5]
[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "floor"
[[spheres]]
center = [-1.2, 0.9, 0.2]
radius = 0.7
material = "red"
[[spheres]]
center = [0.8, 1.8, 0.4]
radius = 0.6
material = "green"
[[spheres]]
center = [2.1, 0.8, -0.6]
radius = 0.4
material = "stone"
[[spheres]]
center = [0.9, 3.2, 0.1]
radius = 0.5
material = "red"
[[spheres]]
center = [-0.5, -1, -0.3]
radius = 0.9
material = "green"
"""
LIGHTS = {
    "a lamp in a ball": '[[lights]]\ntype = "point"\nposition = [0.6, 1.9, 0.2]\nintensity = 3\n',
    "a light from afar": '[[lights]]\ntype = "directional"\ndirection = [0.5, -1, -0.2]\nintensity = 0.8\n',
}


def floor_under(scene, point):
    """What the floor shows at each point."""
    described = tomllib.loads(scene)
    light = described["lights"][0]
    if light["type"] == "point":
        to_light = np.array(light["position"]) - point
        irradiance = light["intensity"] / dot(to_light, to_light)[..., None]
    else:
        to_light = -8 * unit(np.array(light["direction"])) + 0 * point
        irradiance = light["intensity"]
    length = np.linalg.norm(to_light, axis=-1)
    share = np.ones(point.shape)
    for sphere in described["spheres"]:
        inside = np.zeros(length.shape)
        for step in (np.arange(STEPS) + 0.5) / STEPS:
            offset = point + step * to_light - np.array(sphere["center"])
            inside += dot(offset, offset) < sphere["radius"] ** 2
        material = described["materials"][sphere["material"]]
        if material["type"] == "dielectric":
            share *= np.exp(-np.array(material["absorption"]) * (inside / STEPS * length)[..., None])
        else:
            share[inside > 0] = 0
    return FLOOR * share * irradiance * unit(to_light)[..., 1:2]


def check(attempt):
    for what, light in LIGHTS.items():
        scene = ROOM + light
        eye, direction = rays(scene, SIZE)
        distance, _, index = closest(scene, eye, direction)
        floor = (index == len(tomllib.loads(scene)["spheres"]))[..., None]
        picture = attempt.render(scene=scene, size=SIZE)
        expected = floor_under(scene, eye + distance[..., None] * direction)
        attempt.expect_same(picture, np.where(floor, expected, picture), f"the floor under {what}", tolerance=4e-3)
