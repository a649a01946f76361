# SPDX-License-Identifier: MIT
"""Many spheres, each of them tried, in double: no tree at all."""
from core_scenes import TREE_SCENES
from exercises import traced

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
    attempt.expect_each(TREE_SCENES, traced)
