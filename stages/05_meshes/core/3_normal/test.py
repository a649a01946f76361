# SPDX-License-Identifier: MIT
"""Normals blended by weights that are solved for in double."""
from exercises import with_mesh

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
EYE = """
[camera]
position = [0.2, 0.7, 4]
look_at = [0, 0.5, 0]
fov = 55
[background]
color = [0.1, 0.2, 0.3]
[materials.white]
type = "diffuse"
"""
ROOF = """[[meshes]]
file = "mesh.obj"
material = "white"
"""
BALL = """[[spheres]]
center = [-0.5, 0.85, 0.8]
radius = 0.25
"""
WALL = """[[planes]]
normal = [0, 0.1, 1]
point = [0, 0, -3]
"""
LIGHTS = """[[lights]]
type = "point"
position = [-0.6, 2.6, 2]
intensity = 4
[[lights]]
type = "directional"
direction = [-0.6, -1, -0.7]
color = [0.2, 0.3, 0.4]
"""
MISTAKES = [
    ("a * XYZ(scene->vertex_normals[triangle.vertices[0]])", "XYZ(scene->vertex_normals[triangle.vertices[0]])",
     "The first corner counts too much: its normal has the weight a."),
    ("a * XYZ(scene->vertex_normals[triangle.vertices[0]])", "(float3)(0.0f)",
     "The first corner has no part in your blend: add its normal, with the weight a."),
    ("+ b * XYZ", "+ c * XYZ",
     "The second corner has the third one's weight: it is b."),
    ("triangle.vertices[2]", "triangle.vertices[1]",
     "The third corner has the second one's normal."),
    ("a * XYZ(scene->vertex_normals[triangle.vertices[0]])", "(1.0f - a) * XYZ(scene->vertex_normals[triangle.vertices[0]])",
     "The first corner counts less the nearer the hit is to it: its weight is a and not 1 - a."),
    ("surface->normal = a *", "surface->normal = cross(edges.b, edges.c) + 0.0f * a *",
     "Triangles are flat: that is the normal of the facet. Blend those of the corners."),
]


def check(attempt):
    (attempt.scratch / "mesh.obj").write_text(MESH)
    for scene, what in ((EYE + ROOF + BALL + WALL + LIGHTS, "a mesh, a sphere and a wall"),
                        (EYE + ROOF + LIGHTS, "a mesh alone"),
                        (EYE + ROOF + WALL, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), with_mesh(scene, MESH), what)
