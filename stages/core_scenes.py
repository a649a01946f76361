# SPDX-License-Identifier: MIT
"""Scenes that several core exercises of a stage draw, each with what it is in words, and what they show."""
import numpy as np
from exercises import bilinear, closest, light_at, rays, texels_of

# --- 02: in diffuse light

LIT_EYE = """
[camera]
position = [0, 1.6, 5]
look_at = [0, 0.7, 0]
fov = 60
[background]
color = [0.1, 0.2, 0.3]
[materials.red]
type = "diffuse"
color = [0.9, 0.4, 0.3]
"""
LIT_BALLS = """[[spheres]]
center = [-0.8, 0.8, 0]
radius = 0.8
material = "red"
[[spheres]]
center = [1, 0.5, 0.5]
radius = 0.5
"""
LIT_LIGHTS = """[[lights]]
type = "point"
position = [2, 3, 3]
intensity = 6
[[lights]]
type = "directional"
direction = [0.6, -1, 0.7]
color = [0.2, 0.3, 0.4]
"""

# --- 03: mirrors

MIRROR_EYE = """
[camera]
position = [0.3, 1.6, 5]
look_at = [0, 0.7, 0]
fov = 60
[background]
color = [0.1, 0.2, 0.3]
[trace]
max_depth = 3
[materials.gold]
type = "mirror"
color = [0.9, 0.7, 0.4]
[materials.varnish]
type = "glossy"
color = [0.8, 0.3, 0.3]
specularity = 0.4
[materials.chalk]
type = "diffuse"
color = [0.5, 0.8, 0.6]
"""
MIRROR_BALLS = """[[spheres]]
center = [-0.8, 0.8, 0]
radius = 0.8
material = "gold"
[[spheres]]
center = [0.9, 0.6, 0.3]
radius = 0.6
material = "varnish"
[[spheres]]
center = [0.1, 0.3, 1.2]
radius = 0.3
material = "gold"
"""
MIRROR_GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "chalk"
"""
MIRROR_LIGHTS = """[[lights]]
type = "point"
position = [2, 3, 3]
intensity = 6
[[lights]]
type = "directional"
direction = [0.6, -1, -0.7]
color = [0.2, 0.3, 0.4]
"""
MIRROR_SCENES = [
    (MIRROR_EYE + MIRROR_GROUND + MIRROR_BALLS + MIRROR_LIGHTS, "mirrors and varnish on chalk"),
    (MIRROR_EYE + MIRROR_BALLS + MIRROR_LIGHTS, "spheres alone"),
    (MIRROR_EYE + MIRROR_GROUND.replace("chalk", "varnish") + MIRROR_LIGHTS, "a plane alone"),
    (MIRROR_EYE + MIRROR_GROUND + MIRROR_BALLS, "no light at all"),
]

# --- 04: glass

GLASS_EYE = """
[camera]
position = [0.3, 1.4, 4.6]
look_at = [0, 0.7, 0]
fov = 55
[background]
color = [0.4, 0.5, 0.7]
[trace]
max_depth = 4
[materials.glass]
type = "dielectric"
absorption = [0.1, 0.6, 0.9]
[materials.bubble]
type = "dielectric"
ior = 0.7
[materials.chalk]
type = "diffuse"
color = [0.5, 0.8, 0.6]
"""
GLASS_BALLS = """[[spheres]]
center = [-0.8, 0.8, 0]
radius = 0.8
material = "glass"
[[spheres]]
center = [0.9, 0.6, 0.3]
radius = 0.6
material = "bubble"
[[spheres]]
center = [0.2, 0.4, -1.5]
radius = 0.4
material = "chalk"
"""
GLASS_GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "chalk"
"""
GLASS_LIGHTS = """[[lights]]
type = "point"
position = [2, 3, 3]
intensity = 8
[[lights]]
type = "directional"
direction = [0.6, -1, -0.7]
color = [0.2, 0.3, 0.4]
"""
GLASS_SCENES = [
    (GLASS_EYE + GLASS_GROUND + GLASS_BALLS + GLASS_LIGHTS, "glass and a bubble on chalk"),
    (GLASS_EYE + GLASS_BALLS + GLASS_LIGHTS, "spheres alone"),
    (GLASS_EYE + GLASS_GROUND + GLASS_LIGHTS, "a plane alone"),
    (GLASS_EYE + GLASS_GROUND + GLASS_BALLS, "no light at all"),
]

# --- 05: a mesh

# A roof over a floor, a small triangle before and a large one behind it, and one behind the eye; normals lean.
MESH = """v -1.2 0.5 0.4
v 0 1.3 0.2
v 1.2 0.5 -0.3
v -1.2 0.5 -1.2
v 0.1 1.3 -1.1
v 1.3 0.5 -1.4
v -2 -0.1 1.5
v 2 -0.1 1.5
v 2 -0.2 -2
v -2 -0.2 -2
v 0.2 0.1 2
v 0.5 0.1 2
v 0.35 0.4 2
v -3 0 7
v 3 0 7
v 0 4 7
v -2.5 -0.2 -2.5
v 2.5 -0.2 -2.5
v 0.2 2.2 -2.5
vn -0.8 0.6 0
vn 0 1 0.2
vn 0.8 0.5 0.3
vn 0.1 1 0
vn 0 0.2 1
f 1//1 2//2 5//4
f 1//1 5//4 4//1
f 2//2 3//3 6//3
f 2//2 6//3 5//4
f 7//2 8//4 9//2
f 7//2 9//2 10//4
f 11//5 12//2 13//5
f 14//5 15//5 16//5
f 17//1 18//3 19//5
"""
MESH_EYE = """
[camera]
position = [0.2, 0.7, 4]
look_at = [0, 0.5, 0]
fov = 55
[background]
color = [0.1, 0.2, 0.3]
[materials.white]
type = "diffuse"
"""
MESH_ROOF = """[[meshes]]
file = "mesh.obj"
material = "white"
"""
MESH_BALL = """[[spheres]]
center = [-0.5, 0.85, 0.8]
radius = 0.25
"""
MESH_WALL = """[[planes]]
normal = [0, 0.1, 1]
point = [0, 0, -3]
"""
MESH_LIGHTS = """[[lights]]
type = "point"
position = [-0.6, 2.6, 2]
intensity = 4
[[lights]]
type = "directional"
direction = [-0.6, -1, -0.7]
color = [0.2, 0.3, 0.4]
"""
MESH_SCENES = [
    (MESH_EYE + MESH_ROOF + MESH_BALL + MESH_WALL + MESH_LIGHTS, "a mesh, a sphere and a wall"),
    (MESH_EYE + MESH_ROOF + MESH_LIGHTS, "a mesh alone"),
    (MESH_EYE + MESH_ROOF + MESH_WALL, "no light at all"),
]

# --- 06: a picture around a sphere

PICTURE_EYE = """
[camera]
position = [%s]
look_at = [0, 0, 0]
fov = 50
[background]
color = [0.1, 0.2, 0.3]
[materials.picture]
type = "diffuse"
texture = "gradient.png"
[[spheres]]
center = [0, 0, 0]
radius = 1
material = "picture"
[[lights]]
type = "directional"
direction = [%s]
"""
PICTURE_GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, -1, 0]
"""
PICTURE_SCENES = [
    (PICTURE_EYE % ("0.6, 0.5, 2.9", "-0.5, -0.3, -1"), "the front of a sphere"),
    (PICTURE_EYE % ("0.4, 0.3, -2.9", "-0.3, -0.3, 1") + PICTURE_GROUND,
     "its back, where the edges of the picture meet"),
    (PICTURE_EYE % ("0.3, 2.9, 0.3", "-0.3, -1, -0.2"), "its north pole"),
]


def pictured(scene):
    """What a sphere around the world's origin shows of its picture, in light."""
    eye, direction = rays(scene)
    distance, normal, index = closest(scene, eye, direction)
    q = np.where(index[..., None] == 0, normal, [0.0, 0, 1])
    u = 0.5 + np.arctan2(q[..., 0], q[..., 2]) / (2 * np.pi)
    v = 0.5 - np.arcsin(np.clip(q[..., 1], -1, 1)) / np.pi
    color = np.where(index[..., None] == 0, bilinear(texels_of("gradient.png"), u, v), 1)
    seen = np.isfinite(distance)
    color[seen] *= light_at(scene, (eye + np.where(seen, distance, 0)[..., None] * direction)[seen], normal[seen])
    return np.where(seen[..., None], color, [0.1, 0.2, 0.3])


# --- 09: many spheres

TREE_EYE = """
[camera]
position = [0.3, 1.2, 4.5]
look_at = [0, 0.7, 0]
fov = 60
[background]
color = [0.1, 0.2, 0.3]
"""
TREE_PLACES = [(x, y, z) for x in (-1.5, -0.5, 0.5, 1.5) for y in (0.3, 1.2) for z in (-1, 0.4)]
TREE_BALLS = "".join(f"""[[spheres]]
center = [{x + 0.1 * z}, {y}, {z}]
radius = {0.3 + 0.05 * y}
""" for x, y, z in TREE_PLACES)
TREE_NEAR_THE_EYE = """[[spheres]]
center = [0.6, 1.3, 4.9]
radius = 0.3
[[spheres]]
center = [-0.3, 1, 4.1]
radius = 0.05
"""
TREE_GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
"""
TREE_LIGHTS = """[[lights]]
type = "point"
position = [1, 3, 3]
intensity = 6
[[lights]]
type = "directional"
direction = [0.6, -1, -0.7]
color = [0.2, 0.3, 0.4]
"""
TREE_SCENES = [
    (TREE_EYE + TREE_BALLS + TREE_GROUND + TREE_LIGHTS, "sixteen spheres on a plane"),
    (TREE_EYE + TREE_BALLS + TREE_NEAR_THE_EYE + TREE_LIGHTS, "spheres before, beside and behind the eye"),
    (TREE_EYE + TREE_GROUND + TREE_LIGHTS, "a plane alone, which is in no tree"),
    (TREE_EYE + TREE_BALLS + TREE_GROUND, "no light at all"),
]
