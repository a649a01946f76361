# SPDX-License-Identifier: MIT
"""Each channel is that of the course's own picture of glass with that channel's index; without glass, nothing changes."""
import numpy as np
from exercises import expect, scene_text

IOR, DISPERSION = 1.5, 0.06
GLASS = """
[camera]
position = [0.3, 1.6, 5]
look_at = [0, 0.7, 0]
fov = 50
[background]
color = [0.7, 0.8, 0.9]
[materials.glass]
type = "dielectric"
ior = 1.5
absorption = [0.3, 0.1, 0.05]
[materials.floor]
type = "glossy"
color = [0.8, 0.6, 0.5]
specularity = 0.3
[materials.board]
type = "diffuse"
texture = "checker.png"
[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "floor"
[[spheres]]
center = [-0.9, 0.8, 0]
radius = 0.8
material = "glass"
[[meshes]]
file = "cube.obj"
position = [1.1, 0.71, 0.3]
rotation = [10, 30, 0]
scale = 0.6
material = "glass"
[[meshes]]
file = "panel.obj"
position = [0, 1.2, -2]
scale = 2
material = "board"
[[lights]]
type = "point"
position = [2, 4, 3]
intensity = 12
"""
# Rays are cut off by their largest channel; here all are followed.
ALL = ("--method", "depth=fixed", "--depth", "6")


def check(attempt):
    picture = attempt.render(*ALL, scene=GLASS)
    own = [attempt.render(*ALL, scene=GLASS.replace("ior = 1.5", f"ior = {ior}"), original=True)
           for ior in (IOR - DISPERSION, IOR, IOR + DISPERSION)]
    expected = np.stack([own[channel][..., channel] for channel in range(3)], axis=-1)
    expect(np.abs(own[0] - own[2]).max() > 0.1, "the test's glass shows no difference")
    for channel, name in enumerate(("red", "green", "blue")):
        attempt.expect_same(picture[..., channel:channel + 1], expected[..., channel:channel + 1], f"glass, {name}", tolerance=1e-4,
                            strays=0.001)
    scene = scene_text("05_materials.toml")
    attempt.expect_same(attempt.render(scene=scene), attempt.render(scene=scene, original=True), "a scene without glass",
                        tolerance=1e-4, strays=0.001)
