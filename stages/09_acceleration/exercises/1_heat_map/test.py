# SPDX-License-Identifier: MIT
"""A row of eight triangles, so far apart that the tree over them is known; each ray walks down that in double. Then the
bunny, where packets walk together and alone."""
import numpy as np
from exercises import expect, rays

HOT, SIZE = 64, (80, 48)
# Where they are, and how large: one behind the other, so that what is near hides what is far.
ROW = [(0.0, 0.1, 0, 0.5), (0.4, 0.0, -1.7, 0.6), (-0.5, 0.2, -3.1, 0.7), (0.2, -0.4, -5.2, 0.8), (-0.3, -0.3, -6.6, 1.0),
       (0.9, 0.5, -9.1, 1.2), (-1.1, 0.6, -10.9, 1.3), (0.1, 0.2, -13.3, 2.5)]
SCENE = """
[camera]
position = [0.3, 0.2, 4]
look_at = [0, 0, -6]
fov = 40
[materials.clay]
type = "diffuse"
[[meshes]]
file = "row.obj"
material = "clay"
"""


def corners():
    shape = np.array([[-1, -0.9, 0.2], [1, -0.8, -0.15], [0.1, 1, 0.1]])
    return np.array([np.array([x, y, z]) + size * shape for x, y, z, size in ROW])


def area(low, high):
    x, y, z = high - low
    return x * y + y * z + z * x


def tree_of(triangles):
    """A branch's two children; a leaf is the array of its triangles. By the surface area heuristic, all cuts tried."""
    def box(some):
        return some.min(axis=(0, 1)), some.max(axis=(0, 1))

    if len(triangles) == 1:
        return triangles
    cuts = []
    for axis in range(3):
        order = triangles[np.argsort(np.add(*np.moveaxis(np.array([box(t[None]) for t in triangles]), 1, 0))[:, axis])]
        cuts += [(area(*box(order[:n])) * n + area(*box(order[n:])) * (len(order) - n), axis, n, order)
                 for n in range(1, len(order))]
    _, _, n, order = min(cuts, key=lambda cut: cut[0])
    return [(box(part), tree_of(part)) for part in (order[:n], order[n:])]


def hit(eye, direction, triangle):
    a, b, c = triangle
    try:
        t, u, v = np.linalg.solve(np.stack([-direction, b - a, c - a], axis=1), eye - a)
    except np.linalg.LinAlgError:
        return np.inf
    return t if t > 0 and u >= 0 and v >= 0 and u + v <= 1 else np.inf


def nodes_of(eye, direction, tree):
    """How many are looked into: nearest first, and none beyond the closest hit so far."""
    waiting, limit, count = [(0.0, tree)], np.inf, 0
    while waiting:
        enter, node = waiting.pop()
        if enter >= limit:
            continue
        count += 1
        found = []
        for (low, high), child in node:
            ends = np.sort([(low - eye) / direction, (high - eye) / direction], axis=0)
            enters, leaves = max(ends[0].max(), 0), ends[1].min()
            if enters <= min(leaves, limit):
                found.append((enters, child))
        for enters, child in found:
            if isinstance(child, np.ndarray):
                limit = min([limit] + [hit(eye, direction, triangle) for triangle in child])
        waiting += sorted([f for f in found if isinstance(f[1], list)], key=lambda f: -f[0])
    return count


def check(attempt):
    triangles = corners()
    with open(attempt.scratch / "row.obj", "w") as file:
        for corner in triangles.reshape(-1, 3):
            file.write("v " + " ".join(map(str, corner)) + "\n")
        for i in range(0, 3 * len(triangles), 3):
            file.write(f"f {i + 1} {i + 2} {i + 3}\n")
    tree = tree_of(triangles)
    eye, direction = rays(SCENE, SIZE)
    expected = np.array([[nodes_of(eye, d, tree) for d in row] for row in direction])
    picture = attempt.render("--method", "width=1", "nodes=2", scene=SCENE, size=SIZE)
    counted = np.rint(picture.sum(axis=-1) * HOT / 3).astype(int)
    wrong = (counted != expected).sum()
    y, x = np.unravel_index(np.argmax(counted != expected), counted.shape)
    expect(wrong <= 0.01 * expected.size, f"one ray at a time: {wrong} of {expected.size} counts are wrong; at ({x}, {y}) "
           f"it is {counted[y, x]} and should be {expected[y, x]}")
    single = attempt.render("--method", "width=1").sum(axis=-1)
    shared = attempt.render("--method", "width=16").sum(axis=-1)
    fewer = (shared < single - 1e-3).mean()
    expect(fewer <= 0.01, f"sixteen rays at a time: a packet looks into what any of its rays would, but {fewer:.1%} of the "
           "pixels have fewer nodes than by themselves")
    packets = shared.reshape(12, 2, 4, 20, 2, 4)
    expect((np.ptp(packets, axis=(2, 5)) < 1e-3).all(), "pixels of one packet must have one count")
    blocks = np.ptp(packets, axis=(1, 2, 4, 5))
    expect((blocks > 1e-3).mean() > 0.05, "packets that walk alone must be counted alone: in nearly all blocks of four all have "
           "one count")
