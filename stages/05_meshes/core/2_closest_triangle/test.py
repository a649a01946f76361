# SPDX-License-Identifier: MIT
"""Triangles before and behind each other and a sphere: three equations each, solved in double."""
from exercises import traced, with_mesh

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
    ("closest->barycentric = barycentric", "closest->barycentric = (float2)(0.0f)",
     "Each triangle has one colour: the weights of its corners are not kept."),
    ("SHAPE_TRIANGLE, i)", "SHAPE_TRIANGLE, 0)",
     "All triangles are taken for the first one: hand its own index to keep_closer."),
    ("int i = 0;", "int i = 1;",
     "The first triangle is missing: indices begin with 0."),
    ("++i", "i += 2",
     "Every second triangle is missing: the loop takes steps of 1."),
    ("            closest->barycentric = barycentric;\n", "            closest->barycentric = barycentric;\n            break;\n",
     "The first triangle that is hit wins: go on to the end of the list, since a later one may be nearer."),
    ("if (keep_closer(closest, distance, SHAPE_TRIANGLE, i)) {",
     "if (distance < INFINITY) { closest->distance = distance; closest->shape = SHAPE_TRIANGLE; closest->index = i;",
     "The last triangle wins over all that is nearer: ask keep_closer."),
]


def check(attempt):
    (attempt.scratch / "mesh.obj").write_text(MESH)
    for scene, what in ((EYE + ROOF + BALL + WALL + LIGHTS, "a mesh, a sphere and a wall"),
                        (EYE + ROOF + LIGHTS, "a mesh alone"),
                        (EYE + ROOF + WALL, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), with_mesh(scene, MESH), what)
    scene = EYE + BALL + WALL + LIGHTS
    attempt.expect_same(attempt.render(scene=scene), traced(scene), "no mesh at all")
