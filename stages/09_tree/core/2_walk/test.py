# SPDX-License-Identifier: MIT
"""Many spheres, each of them tried, in double: no tree at all."""
from exercises import traced

EYE = """
[camera]
position = [0.3, 1.2, 4.5]
look_at = [0, 0.7, 0]
fov = 60
[background]
color = [0.1, 0.2, 0.3]
"""
PLACES = [(x, y, z) for x in (-1.5, -0.5, 0.5, 1.5) for y in (0.3, 1.2) for z in (-1, 0.4)]
BALLS = "".join(f"""[[spheres]]
center = [{x + 0.1 * z}, {y}, {z}]
radius = {0.3 + 0.05 * y}
""" for x, y, z in PLACES)
NEAR_THE_EYE = """[[spheres]]
center = [0.6, 1.3, 4.9]
radius = 0.3
[[spheres]]
center = [-0.3, 1, 4.1]
radius = 0.05
"""
GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
"""
LIGHTS = """[[lights]]
type = "point"
position = [1, 3, 3]
intensity = 6
[[lights]]
type = "directional"
direction = [0.6, -1, -0.7]
color = [0.2, 0.3, 0.4]
"""
LEAF = "try_leaf(scene, ray, node->first[child], node->count[child], closest);"
MISTAKES = [
    ("child < 4", "child < 3",
     "The last child of each node is missing: there are four."),
    ("int child = 0", "int child = 1",
     "The first child of each node is missing: they count from 0."),
    ("else if (t[child] >= 0.0f)", "else if (t[child] > 0.0f)",
     "Nodes around the ray's origin are missing: a box that is entered at 0 counts."),
    (LEAF, "try_leaf(scene, ray, node->first[child], 1, closest);",
     "Spheres are missing: hand try_leaf the leaf's own count, which is below 0 for spheres."),
    (LEAF, "if (closest->shape == SHAPE_NONE) { try_leaf(scene, ray, node->first[child], node->count[child], closest); }",
     "What is hit first in the tree wins, not the nearest: try all leaves that are entered."),
    ("int place = count++;", "int place = bottom;\n                count = bottom + 1;",
     "Of the nodes that a ray enters only one is looked into: each needs a place of its own on the stack."),
]


def check(attempt):
    for scene, what in ((EYE + BALLS + GROUND + LIGHTS, "sixteen spheres on a plane"),
                        (EYE + BALLS + NEAR_THE_EYE + LIGHTS, "spheres before, beside and behind the eye"),
                        (EYE + GROUND + LIGHTS, "a plane alone, which is in no tree"),
                        (EYE + BALLS + GROUND, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), traced(scene), what)
