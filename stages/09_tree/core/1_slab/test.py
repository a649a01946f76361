# SPDX-License-Identifier: MIT
"""Many spheres, each of them tried, in double: no box at all."""
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
MISTAKES = [
    ("inverse < 0.0f ? axis + 3 : axis]", "axis]",
     "Boxes are missing where a direction is below 0: the ray meets the high plane first there."),
    ("float4 enter = 0.0f", "float4 enter = -INFINITY",
     "Boxes around the ray's origin are missing: they are entered at 0, and not behind it."),
    ("enter <= leave", "enter > leave",
     "You enter the boxes that the ray misses: it is in a box when it enters before it leaves."),
    ("(float4)(-(origin[axis] + padding) * inverse)", "(float4)((origin[axis] + padding) * inverse)",
     "The near planes are in the wrong place: the origin is taken away."),
    ("leave = fmin(leave,", "leave = fmin((float4)(0.0f),",
     "Only boxes around the origin are entered: what is left of each axis is the smaller of its exit and leave."),
    ("leave = t_max", "leave = 1.0f",
     "Boxes farther away than 1 are missing: they may be entered up to t_max."),
]


def check(attempt):
    for scene, what in ((EYE + BALLS + GROUND + LIGHTS, "sixteen spheres on a plane"),
                        (EYE + BALLS + NEAR_THE_EYE + LIGHTS, "spheres before, beside and behind the eye"),
                        (EYE + GROUND + LIGHTS, "a plane alone, which is in no tree"),
                        (EYE + BALLS + GROUND, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), traced(scene), what)
