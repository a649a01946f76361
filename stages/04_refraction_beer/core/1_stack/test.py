# SPDX-License-Identifier: MIT
"""Glass, which splits rays, traced in double."""
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
PUSH = "copy_pending(&stack->rays[place_of(stack, stack->count++)], &ray);"
MISTAKES = [
    ("ray.depth > MAX_DEPTH", "ray.depth >= MAX_DEPTH",
     "Rays end one bounce too early: those at the limit itself are traced."),
    ("stack->count++", "stack->count",
     "Nothing that is pushed is ever found: add 1 to the count."),
    (PUSH, "copy_pending(&stack->rays[0], &ray);\n        stack->count = 1;",
     "A new ray takes the place of one that waits, or all is thrown away where one is taken: the count says how "
     "many wait."),
    (PUSH, "if (stack->count == 0) { copy_pending(&stack->rays[stack->count++], &ray); }",
     "A second ray is refused where one waits already: there are MAX_DEPTH + 1 places."),
    ("ray.depth > MAX_DEPTH", "ray.depth > 2",
     "Rays end after two bounces: the limit is MAX_DEPTH, which the scene says."),
]


def check(attempt):
    for scene, what in ((EYE + GROUND + BALLS + LIGHTS, "glass and a bubble on chalk"),
                        (EYE + BALLS + LIGHTS, "spheres alone"),
                        (EYE + GROUND + LIGHTS, "a plane alone"),
                        (EYE + GROUND + BALLS, "no light at all")):
        attempt.expect_same(attempt.render(scene=scene), traced(scene), what)
