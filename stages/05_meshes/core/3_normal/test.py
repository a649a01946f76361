# SPDX-License-Identifier: MIT
"""Normals blended by weights that are solved for in double."""
from core_scenes import MESH, MESH_SCENES
from exercises import with_mesh

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
    attempt.expect_each(MESH_SCENES, lambda scene: with_mesh(scene, MESH))
