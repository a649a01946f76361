# SPDX-License-Identifier: MIT
"""Without bounces, the picture without fog seen through it; without lights, a sum along each path, in double."""
import tomllib
import numpy as np
from exercises import closest, dot, rays

SCENE = "03_reflection_glossy.toml"
DENSITY, FOG = 0.07, np.array([0.66, 0.68, 0.7])

# Nothing is diffuse and nothing shines: all that is seen is fog.
UNLIT = """
[camera]
position = [0.5, 1.2, 5]
look_at = [0, 0.8, 0]
fov = 60
[background]
color = [0.9, 0.2, 0.2]
[materials.floor]
type = "glossy"
color = [0.9, 0.7, 0.8]
specularity = 0.6
[materials.silver]
type = "mirror"
color = [0.9, 0.95, 0.85]
[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "floor"
[[spheres]]
center = [-0.9, 0.8, 0]
radius = 0.8
material = "silver"
[[spheres]]
center = [1.2, 1, -0.4]
radius = 1
material = "silver"
"""


def unlit():
    described = tomllib.loads(UNLIT)
    materials = [described["materials"][s["material"]] for s in described["spheres"] + described["planes"]]
    reflectance = np.array([np.array(m["color"]) * m.get("specularity", 1) for m in materials] + [[0, 0, 0]])
    origin, direction = rays(UNLIT)
    color, weight = np.zeros(direction.shape), np.ones(direction.shape)
    for _ in range(9):
        distance, normal, index = closest(UNLIT, origin, direction)
        clear = np.exp(-DENSITY * distance)[..., None]
        color += weight * (1 - clear) * FOG
        weight *= clear * reflectance[index]
        origin = origin + np.where(np.isfinite(distance), distance, 0)[..., None] * direction
        direction = direction - 2 * dot(direction, normal)[..., None] * normal
    return color


def check(attempt):
    eye, direction = rays(SCENE)
    clear = np.exp(-DENSITY * closest(SCENE, eye, direction)[0])[..., None]
    expected = clear * attempt.render("--depth", 0, original=True) + (1 - clear) * FOG
    attempt.expect_same(attempt.render("--depth", 0), expected, "fog before the first hit")
    attempt.expect_same(attempt.render(scene=UNLIT), unlit(), "fog between mirrors")
