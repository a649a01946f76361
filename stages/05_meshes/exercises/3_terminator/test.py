# SPDX-License-Identifier: MIT
"""A ball of facets, lit as a ball is: dark where its normals turn away and in the shadow of a sphere, and nowhere
else. The inside of a bowl stays as the course draws it."""
import numpy as np
from exercises import dot, hit_sphere, hit_triangles, rays, triangles_of, unit

LIGHT = unit(np.array([1.0, 0.45, 0.15]))
BLOCKER, RADIUS = [1.5, 1.15, 0.45], 0.25
SCENE = f"""
[camera]
position = [0.4, 0.9, 3.2]
look_at = [0.1, 0.1, 0]
fov = 45
[materials.white]
type = "diffuse"
[[meshes]]
file = "mesh.obj"
material = "white"
[[lights]]
type = "directional"
direction = {(-LIGHT).tolist()}
"""
WITH_BLOCKER = SCENE + f"""[[spheres]]
center = {BLOCKER}
radius = {RADIUS}
"""
FROM_ABOVE = SCENE.replace("[0.4, 0.9, 3.2]", "[-0.3, 2.2, 0.3]")


def ball(first_row, columns=12, rows=7):
    """OBJ of a ball of radius 1, or of what is left of it without its upper rows; normals point outwards."""
    lines = []
    for polar in np.pi * np.arange(rows + 1) / rows:
        for angle in 2 * np.pi * np.arange(columns) / columns:
            point = np.sin(polar) * np.cos(angle), np.cos(polar), np.sin(polar) * np.sin(angle)
            lines += ["v %.9f %.9f %.9f" % point, "vn %.9f %.9f %.9f" % point]
    for row in range(first_row, rows):
        for column in range(columns):
            a, b = (row * columns + 1 + c % columns for c in (column, column + 1))
            for face, is_there in (((a, b, a + columns), row > 0), ((b, b + columns, a + columns), row < rows - 1)):
                lines += ["f " + " ".join(f"{i}//{i}" for i in face)] * is_there
    return "\n".join(lines) + "\n"


def check(attempt):
    mesh = attempt.scratch / "mesh.obj"
    mesh.write_text(ball(0))
    corners, normals = triangles_of(mesh.read_text())
    eye, direction = rays(SCENE)
    distance, index, weights = hit_triangles(eye, direction, corners)
    seen = np.isfinite(distance) & (distance < hit_sphere(eye, direction, BLOCKER, RADIUS))
    point = eye + np.where(seen, distance, 0)[..., None] * direction
    normal = unit(np.sum(weights[..., None] * normals[index], axis=-2) + ~seen[..., None])
    lit = ~np.isfinite(hit_sphere(point, LIGHT, BLOCKER, RADIUS))
    expected = (np.maximum(dot(normal, LIGHT), 0) * lit)[..., None] * np.ones(3)
    picture = attempt.render(scene=WITH_BLOCKER)
    attempt.expect_same(np.where(seen[..., None], picture, 0), np.where(seen[..., None], expected, 0),
                        "light on a ball of facets")

    mesh.write_text(ball(4))
    attempt.expect_same(attempt.render(scene=FROM_ABOVE), attempt.render(scene=FROM_ABOVE, original=True),
                        "light in a bowl, seen from within", strays=0)
