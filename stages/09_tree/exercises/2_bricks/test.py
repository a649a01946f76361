# SPDX-License-Identifier: MIT
"""Squares so far apart and so tilted that the two triangles of each must be one leaf: what of their boxes is seen, by three
slabs in double."""
import numpy as np
from exercises import expect, rays

# Behind each other too; the eye is in the last.
SQUARES = [(0, 0, 0), (1.2, 0.6, -2.5), (-1.6, 0.5, -3.5), (0.5, -1.2, -6), (-3, 2.2, -9), (0.3, 0.6, 5.2)]
BEGIN = """
[camera]
position = [0.4, 0.7, 5]
look_at = [0, 0, -2]
fov = 52
[materials.clay]
type = "diffuse"
"""
TURN = [40, 35, 0]
SCENE = BEGIN + "".join(f"""
[[meshes]]
file = "panel.obj"
position = [{x}, {y}, {z}]
rotation = {TURN}
scale = {0.6 + 0.1 * i}
material = "clay"
""" for i, (x, y, z) in enumerate(SQUARES))


def half_extents():
    """Of the square of edge 2, turned: about x, then y, then z (docs/scene-format.md)."""
    a, b = np.radians(TURN[:2])
    about_x = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    about_y = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
    return np.abs(np.array([[1, 1, 0], [1, -1, 0]]) @ (about_y @ about_x).T).max(axis=0)


def check(attempt):
    eye, direction = rays(SCENE)
    distance, axis, which = np.full(direction.shape[:2], np.inf), np.zeros(direction.shape[:2], int), np.full(direction.shape[:2], -1)
    for number, square in enumerate(SQUARES):
        half = half_extents() * (0.6 + 0.1 * number)
        planes = np.stack([(np.array(square) + sign * half - eye) / direction for sign in (-1, 1)])
        enters, leave = planes.min(axis=0), planes.max(axis=0).min(axis=-1)
        enter = enters.max(axis=-1)
        hit = (enter > 0) & (enter <= leave) & (enter < distance)
        distance[hit], axis[hit], which[hit] = enter[hit], enters.argmax(axis=-1)[hit], number
    expect(set(np.unique(which)) == {-1, 0, 1, 2, 3, 4}, "the test's picture lacks a brick")
    picture = attempt.render(scene=SCENE)
    # A hue's strongest channel is 1: what is left is the side's.
    expected = np.where(which >= 0, 1 - 0.25 * axis, 0)
    attempt.expect_same(picture.max(axis=-1)[..., None], expected[..., None], "which side is seen", strays=0.004)
    hues = picture / np.maximum(picture.max(axis=-1), 1e-6)[..., None]
    middles = [np.median(hues[which == number], axis=0) for number in range(5)]
    for number, middle in enumerate(middles):
        others = (np.abs(hues[which == number] - middle).max(axis=-1) > 0.01).mean()
        expect(others < 0.02, f"a brick must have one colour: of one, {others:.1%} has another; is the nearest seen?")
    expect(len({tuple(np.round(middle, 2)) for middle in middles}) == 5, "each brick must have a colour of its own")
