# SPDX-License-Identifier: MIT
"""Triangles from both sides, a small one and one behind the eye: three equations each, solved in double."""
from core_scenes import MESH, MESH_SCENES
from exercises import with_mesh

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
    attempt.expect_each(MESH_SCENES, lambda scene: with_mesh(scene, MESH))
