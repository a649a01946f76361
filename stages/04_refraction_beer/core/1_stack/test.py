# SPDX-License-Identifier: MIT
"""Glass, which splits rays, traced in double."""
from core_scenes import GLASS_SCENES
from exercises import traced

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
    attempt.expect_each(GLASS_SCENES, traced)
