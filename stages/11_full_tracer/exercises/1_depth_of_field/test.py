# SPDX-License-Identifier: MIT
"""Three black squares before a white sky, one nearer than the plane in focus, one in it and one beyond. What part of the lens each
hides from a pixel: counted over a fine grid of the lens, by where lines cross the squares' planes."""
import numpy as np
from exercises import dot, expect, rays, unit

FOCUS, RADIUS, FOV = 6.0, 0.12, 84
# Middle and half of the edge; the one in focus is far from the axis, where its plane is farther away than FOCUS.
SQUARES = [((-1.2, 0.6, 3.0), 0.7), ((3.9, -1.0, 0.0), 1.3), ((4.0, 3.5, -9.0), 3.0)]
SCENE = f"""
[camera]
position = [0, 0.2, 6]
look_at = [0, 0.2, 0]
fov = {FOV}
[background]
color = [1, 1, 1]
[materials.black]
type = "diffuse"
color = [0, 0, 0]
""" + "".join(f"""
[[meshes]]
file = "panel.obj"
position = {list(middle)}
scale = {half}
material = "black"
""" for middle, half in SQUARES)


def check(attempt):
    eye, direction = rays(SCENE)
    in_focus = eye + direction * (FOCUS / -direction[..., 2])[..., None]
    steps = (np.arange(40) + 0.5) / 20 - 1
    lens = np.array([(x, y, 0) for x in steps for y in steps if x * x + y * y < 1]) * RADIUS
    open_sky = np.zeros(direction.shape[:2])
    for point in lens:
        start = eye + point
        along = in_focus - start
        free = np.full(open_sky.shape, True)
        for middle, half in SQUARES:
            at = start + along * ((middle[2] - start[2]) / along[..., 2])[..., None] - middle
            free &= (np.abs(at[..., :2]) > half).any(axis=-1)
        open_sky += free / len(lens)
    picture = attempt.render(scene=SCENE)
    # 32 points fill a segment right to some hundredths.
    attempt.expect_same(picture, np.repeat(open_sky[..., None], 3, axis=-1), "squares nearer, in focus and beyond", tolerance=0.08,
                        strays=0.001)
    bias = abs((picture[..., 0] - open_sky).mean())
    expect(bias < 0.002, f"in the mean the sky is off by {bias:.2g}: the lens is not round its middle")
    # Turned, and seen from elsewhere, the camera's own axes count.
    turned = SCENE.replace("position = [0, 0.2, 6]\nlook_at = [0, 0.2, 0]", "position = [0, 0.2, 6]\nup = [1, 0.4, 0]\nlook_at = [0, 0.2, 0]")
    picture = attempt.render(scene=turned)
    _, direction = rays(turned)
    up = unit(np.array([1, 0.4, 0]))
    right = np.cross([0, 0, -1], up)
    # Where each pixel's direction lies in the picture that is not turned.
    x = direction[..., 0] / -direction[..., 2]
    y = direction[..., 1] / -direction[..., 2]
    expect(abs(dot(right, up)) < 1e-12, "the test's axes")
    half_width = np.tan(np.radians(FOV / 2))
    column = np.rint((x / half_width + 1) * 80 - 0.5).astype(int)
    row = np.rint((0.6 - y / half_width) * 80 - 0.5).astype(int)
    inside = (column >= 0) & (column < 160) & (row >= 0) & (row < 96)
    off = np.abs(picture[..., 0][inside] - open_sky[row[inside], column[inside]])
    expect(off.mean() < 0.03, f"with the camera turned about its axis the picture differs by {off.mean():.2g} in the mean")
