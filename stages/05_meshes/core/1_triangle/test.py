# SPDX-License-Identifier: MIT
"""Triangles from both sides, a small one and one behind the eye: three equations each, solved in double."""
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
    ("!(b >= 0.0f && b <= 1.0f)", "false",
     "Triangles go on beyond one of their edges: the weight b is at least 0."),
    ("b + c <= 1.0f", "c <= 1.0f",
     "You see parallelograms: b and c together are at most 1."),
    ("return t > 0.0f ? t : INFINITY;", "return t;",
     "You see a triangle behind the eye: a negative t is no hit."),
    ("determinant == 0.0f", "determinant <= 0.0f",
     "Triangles are missing where they are seen from behind: the determinant is negative there."),
    ("determinant == 0.0f", "fabs(determinant) < 0.1f",
     "The small triangle is missing: compare the determinant with 0, and with no other threshold."),
    ("(float2)(b, c)", "(float2)(c, b)",
     "The light on triangles is wrong, their outlines are right: the weights of the second and third corner are "
     "swapped."),
    ("dot(triangle.c, q) * inverse", "dot(triangle.c, q)",
     "The distance is wrong: divide it by the determinant, too."),
]


def check(attempt):
    (attempt.scratch / "mesh.obj").write_text(MESH)
    for scene, what in ((EYE + ROOF + BALL + WALL + LIGHTS, "a mesh, a sphere and a wall"),
                        (EYE + ROOF + LIGHTS, "a mesh alone"),
                        (EYE + ROOF + WALL, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), with_mesh(scene, MESH), what)
