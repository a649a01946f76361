# SPDX-License-Identifier: MIT
"""The normal leans against the slope: outward, less the slopes of the height to the east and to the north, by
differences along the sphere. No neighbour is lifted. From outside and from within."""
import numpy as np
from exercises import bilinear, closest, dot, rays, texels_of, unit, write_png

HEIGHT, STEP = 0.08, 0.0123
CENTER, RADIUS = [0.3, 0.2, -1], 1.3
EXACT = "--method", "filtering=hand"  # whatever precision the device's own filter has
SCENE = f"""
[camera]
position = [%s]
look_at = [%s]
fov = 50
[materials.hills]
type = "diffuse"
texture = "{{hills}}"
[materials.plain]
type = "diffuse"
[[spheres]]
center = {CENTER}
radius = {RADIUS}
material = "hills"
[[spheres]]
center = [1.5, 1.2, 0.8]
radius = 0.3
material = "plain"
[[lights]]
type = "point"
position = {{light}}
intensity = {{intensity}}
"""


def hills(width=64, height=32):
    """A picture of waves, (height, width, 3)."""
    x, y = np.meshgrid(2 * np.pi * np.arange(width) / width, np.pi * np.arange(height) / height)
    waves = [np.sin(5 * x + 3 * y), np.sin(3 * x - 6 * y + 1), np.cos(8 * x) * np.sin(7 * y)]
    return 0.5 + 0.4 * np.stack(waves, axis=-1)


def color(texels, outward):
    """In these directions from the centre."""
    longitude = np.angle(outward[..., 2] + 1j * outward[..., 0])
    latitude = np.arctan2(outward[..., 1], np.hypot(outward[..., 0], outward[..., 2]))
    return bilinear(texels, (longitude + np.pi) / (2 * np.pi), (np.pi / 2 - latitude) / np.pi)


def slope(texels, outward, way):
    """What the landscape rises to that side, for one radius along it."""
    def height(step):
        return HEIGHT * color(texels, np.cos(step) * outward + np.sin(step) * way).mean(axis=-1)
    return (height(STEP) - height(-STEP)) / (2 * STEP)


def bumpy(texels, outward):
    east = unit(np.cross([0, 1, 0], outward))
    north = np.cross(outward, east)
    radius = 1 + HEIGHT * color(texels, outward).mean(axis=-1)
    lean = slope(texels, outward, east)[..., None] * east + slope(texels, outward, north)[..., None] * north
    return unit(radius[..., None] * outward - lean)


def check(attempt):
    path = attempt.scratch / "hills.png"
    write_png(path, hills())
    texels = texels_of(path)
    for place, look_at, light, intensity, what in (
            ("-0.5, 1.5, 3", "0.5, 0.4, -1", [3, 2.5, 3], 15, "bumps from outside"),
            ("0.2, 0.1, -1.6", "0.4, 0.2, 1", [0.7, 0.9, -1.2], 1, "bumps from within")):
        scene = SCENE.format(hills=path, light=light, intensity=intensity) % (place, look_at)
        eye, direction = rays(scene)
        distance, normal, index = closest(scene, eye, direction)
        seen = index == 0
        point = eye + np.where(seen, distance, 1)[..., None] * direction
        outward = np.where(seen[..., None], unit(point - CENTER), [0, 0, 1])
        to_light = unit(np.array(light) - point)
        side = np.sign(dot(outward, normal))
        cosine = side * dot(outward, to_light)
        with_bumps = side * dot(bumpy(texels, outward), to_light)
        # The course's picture has the light, its distance and the shadows, times the smooth sphere's cosine.
        sure = seen & (cosine > 0.1) & (with_bumps > 0.1)
        scale = np.where(sure, with_bumps / np.where(sure, cosine, 1), 1)
        expected = attempt.render(*EXACT, scene=scene, original=True) * scale[..., None]
        unsure = (seen & ~sure)[..., None]
        picture = attempt.render(*EXACT, scene=scene)
        attempt.expect_same(np.where(unsure, 0, picture), np.where(unsure, 0, expected), what, tolerance=0.01)
