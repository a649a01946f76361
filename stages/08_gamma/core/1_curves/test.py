# SPDX-License-Identifier: MIT
"""The standard's two curves in double, of light from black to more than white."""
import numpy as np
from exercises import expect

EYE = """
[camera]
position = [0, 1.4, 4.6]
look_at = [0, 0.7, 0]
fov = 60
[background]
color = [0.002, 0.03, 1.5]
[materials.dark]
type = "diffuse"
color = [0.002, 0.01, 0.3]
"""
SHAPES = """[[spheres]]
center = [-1.2, 0.8, 0]
radius = 0.8
material = "dark"
[[spheres]]
center = [1.2, 0.8, 0]
radius = 0.8
[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "dark"
[[planes]]
normal = [0, 0, 1]
point = [0, 0, -3]
"""
LIGHT = """[[lights]]
type = "point"
position = [0, 3, 2]
color = [1, 0.6, 0.1]
intensity = 12
"""

ENCODE = "l <= 0.0031308f ? 12.92f * l : 1.055f * pow(l, 1.0f / 2.4f) - 0.055f"
MISTAKES = [
    (ENCODE, "1.055f * pow(l, 1.0f / 2.4f) - 0.055f",
     "Dark light has negative values: below 0.0031308 the curve is a straight line."),
    (ENCODE, "pow(l, 1.0f / 2.2f)",
     "That is the power of 2.2 for all, which is near sRGB and not the same."),
    ("pow(l, 1.0f / 2.4f)", "pow(l, 2.4f)",
     "What should become brighter becomes darker: light is encoded with the power of 1 / 2.4."),
    ("pow(l, 1.0f / 2.4f) - 0.055f", "pow(l, 1.0f / 2.4f)",
     "Encoded values are too large: 0.055 is missing at the end."),
    ("(v + 0.055f) / 1.055f", "v + 0.055f / 1.055f",
     "Decoded light is too bright: divide the sum by 1.055, and not 0.055 alone."),
    ("/ 1.055f, 2.4f)", "/ 1.055f, 1.0f / 2.4f)",
     "What should become darker becomes brighter: values are decoded with the power of 2.4."),
    ("float l = within_screen(light);", "float l = light;",
     "Values above 1 come out: cut the light to what a screen can show before you encode it."),
    ("float v = within_screen(value);", "float v = value;",
     "Light above 1 comes out: cut the value to what a screen can show before you decode it."),
]

PLAIN = "convert_float4((float4)(color, 1.0f))"
CURVED = """(pixel.x < width / 2
        ? (float4)(srgb_encode(color.x), srgb_encode(color.y), srgb_encode(color.z), 1.0f)
        : (float4)(srgb_decode(color.x), srgb_decode(color.y), srgb_decode(color.z), 1.0f))"""


def prepare(kernels):
    """Pictures show encoded light on the left, decoded light on the right."""
    file = kernels / "kernels/picture.cl"
    head, *rest = file.read_text().split("#if PICTURE_IS_IMAGE\n")
    expect(len(rest) == 1, "kernels/picture.cl is not as the test expects it")
    before, image, buffer = rest[0].rpartition("image[")
    file.write_text(f'{head}#include "transfer_curves.h"\n\n#if PICTURE_IS_IMAGE\n'
                    + before + image + buffer.replace(PLAIN, CURVED, 1))


def check(attempt):
    for scene, what in ((EYE + SHAPES + LIGHT, "light from black to more than white"), (EYE + SHAPES, "no light at all"),
                        (EYE + SHAPES.split("[[planes]]")[0] + LIGHT, "spheres alone"),
                        (EYE + "[[planes]]" + SHAPES.split("[[planes]]")[1] + LIGHT, "a plane alone")):
        light = np.clip(attempt.render(scene=scene, original=True), 0, 1)
        encoded = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
        decoded = np.where(light <= 0.04045, light / 12.92, ((light + 0.055) / 1.055) ** 2.4)
        left = np.arange(light.shape[1])[:, None] < light.shape[1] // 2
        attempt.expect_same(attempt.render(scene=scene), np.where(left, encoded, decoded), what)
