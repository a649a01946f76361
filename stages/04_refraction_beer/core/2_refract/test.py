# SPDX-License-Identifier: MIT
"""A ball of glass and a bubble, whose rim reflects all, traced in double."""
from exercises import traced

EYE = """
[camera]
position = [0.3, 1.4, 4.6]
look_at = [0, 0.7, 0]
fov = 55
[background]
color = [0.4, 0.5, 0.7]
[trace]
max_depth = 4
[materials.glass]
type = "dielectric"
absorption = [0.1, 0.6, 0.9]
[materials.bubble]
type = "dielectric"
ior = 0.7
[materials.chalk]
type = "diffuse"
color = [0.5, 0.8, 0.6]
"""
BALLS = """[[spheres]]
center = [-0.8, 0.8, 0]
radius = 0.8
material = "glass"
[[spheres]]
center = [0.9, 0.6, 0.3]
radius = 0.6
material = "bubble"
[[spheres]]
center = [0.2, 0.4, -1.5]
radius = 0.4
material = "chalk"
"""
GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "chalk"
"""
LIGHTS = """[[lights]]
type = "point"
position = [2, 3, 3]
intensity = 8
[[lights]]
type = "directional"
direction = [0.6, -1, -0.7]
color = [0.2, 0.3, 0.4]
"""
SUM = "ratio * direction + beyond * normal"
MISTAKES = [
    (f"normalize({SUM})", "direction",
     "Rays go straight on through glass: the direction has to change."),
    ("sine_squared > 1.0f", "false",
     "Some pixels are NaN: return false where the square of the sine is above 1, before the root is taken."),
    ("ratio * cosine - sqrt", "ratio * cosine + sqrt",
     "Refracted rays come out on the side where they came from: the root is subtracted."),
    ("ratio * ratio *", "ratio *",
     "Rays are bent by the wrong angle: the square of the sine has the square of the ratio."),
    ("const float ratio, float3 *refracted) {",
     "const float inverse, float3 *refracted) {\n    const float ratio = 1.0f / inverse;",
     "Glass bends rays away from the normal and the bubble towards it: your ratio is upside down."),
    ("-dot(direction, normal)", "dot(direction, normal)",
     "The cosine has the wrong sign: direction and normal point against each other, so it is minus their dot product."),
]


def check(attempt):
    for scene, what in ((EYE + GROUND + BALLS + LIGHTS, "glass and a bubble on chalk"),
                        (EYE + BALLS + LIGHTS, "spheres alone"),
                        (EYE + GROUND + LIGHTS, "a plane alone"),
                        (EYE + GROUND + BALLS, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), traced(scene), what)
