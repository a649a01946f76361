# SPDX-License-Identifier: MIT
"""A row of triangles, so far apart that the tree over them is known; each ray walks down that in double. Planes hide what is
behind them."""
import numpy as np
from exercises import expect, hit_plane, rays

HOT, SIZE = 64, (80, 48)
# Where they are, and how large: one behind the other, so that what is near hides what is far.
ROW = [(0.0, 0.1, 0, 0.5), (0.4, 0.0, -1.7, 0.6), (-0.5, 0.2, -3.1, 0.7), (0.2, -0.4, -5.2, 0.8), (-0.3, -0.3, -6.6, 1.0),
       (0.9, 0.5, -9.1, 1.2), (-1.1, 0.6, -10.9, 1.3), (0.1, 0.2, -13.3, 2.5), (-1.0, -0.2, -16.9, 1.1), (1.3, 0.4, -18.8, 1.0),
       (-0.2, 1.5, -22.4, 1.5), (1.7, -0.9, -24.1, 1.4), (-2.2, -1.0, -28.3, 1.6), (0.5, 0.1, -30.2, 2.0)]
FLOOR = [0, 1, 0], [0, -0.7, 0]
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
[[planes]]
normal = [0, 1, 0]
point = [0, -0.7, 0]
material = "clay"
"""


def corners():
    shape = np.array([[-1, -0.9, 0.2], [1, -0.8, -0.15], [0.1, 1, 0.1]])
    return np.array([np.array([x, y, z]) + size * shape for x, y, z, size in ROW])


def area(low, high):
    x, y, z = high - low
    return x * y + y * z + z * x


def box(some):
    return some.min(axis=(0, 1)), some.max(axis=(0, 1))


def halves(triangles):
    """By the surface area heuristic, all cuts tried."""
    cuts = []
    for axis in range(3):
        order = triangles[np.argsort(np.add(*np.moveaxis(np.array([box(t[None]) for t in triangles]), 1, 0))[:, axis])]
        cuts += [(area(*box(order[:n])) * n + area(*box(order[n:])) * (len(order) - n), axis, n, order)
                 for n in range(1, len(order))]
    _, _, n, order = min(cuts, key=lambda cut: cut[0])
    return [order[:n], order[n:]]


def tree_of(triangles):
    """A branch's four children or fewer, each with its box: while there is room, the largest is halved. A leaf is the array of
    its one triangle."""
    if len(triangles) == 1:
        return triangles
    children = halves(triangles)
    while len(children) < 4 and any(len(child) > 1 for child in children):
        largest = max(range(len(children)), key=lambda i: area(*box(children[i])) if len(children[i]) > 1 else -1)
        children[largest:largest + 1] = halves(children[largest])
    return [(box(child), tree_of(child)) for child in children]


def hit(eye, direction, triangle):
    a, b, c = triangle
    try:
        t, u, v = np.linalg.solve(np.stack([-direction, b - a, c - a], axis=1), eye - a)
    except np.linalg.LinAlgError:
        return np.inf
    return t if t > 0 and u >= 0 and v >= 0 and u + v <= 1 else np.inf


def nodes_of(eye, direction, tree, limit):
    """How many are looked into: nearest first, and none beyond the closest hit so far."""
    waiting, count = [(0.0, tree)], 0
    while waiting:
        enter, node = waiting.pop()
        if enter > limit:
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
        waiting = sorted(waiting + [f for f in found if isinstance(f[1], list)], key=lambda f: -f[0])
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
    floor = hit_plane(eye, direction, *FLOOR)
    expected = np.array([[nodes_of(eye, *ray, tree, limit) for *ray, limit in zip(*row)] for row in zip(direction, floor)])
    expect(expected.max() >= 4, "the test's tree is too small")
    picture = attempt.render(scene=SCENE, size=SIZE)
    counted = np.rint(picture.sum(axis=-1) * HOT / 3).astype(int)
    wrong = (counted != expected).sum()
    y, x = np.unravel_index(np.argmax(counted != expected), counted.shape)
    expect(wrong <= 0.01 * expected.size, f"{wrong} of {expected.size} counts are wrong; at ({x}, {y}) it is {counted[y, x]} and "
           f"should be {expected[y, x]}")
