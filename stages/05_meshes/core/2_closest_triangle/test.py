# SPDX-License-Identifier: MIT
"""Triangles before and behind each other and a sphere: three equations each, solved in double."""
from core_scenes import MESH, MESH_BALL, MESH_EYE, MESH_LIGHTS, MESH_SCENES, MESH_WALL
from exercises import traced, with_mesh

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
    attempt.expect_each(MESH_SCENES, lambda scene: with_mesh(scene, MESH))
    scene = MESH_EYE + MESH_BALL + MESH_WALL + MESH_LIGHTS
    attempt.expect_same(attempt.render(scene=scene), traced(scene), "no mesh at all")
