# SPDX-License-Identifier: MIT
"""Mirrors that see each other, up to the depth limit, traced in double."""
from core_scenes import MIRROR_BALLS, MIRROR_EYE, MIRROR_GROUND, MIRROR_LIGHTS, MIRROR_SCENES
from exercises import traced

RAY = "reflected.ray = reflected_ray(surface, incoming->ray.direction);"
ONE_BOUNCE = (MIRROR_EYE.replace("max_depth = 3", "max_depth = 1") + MIRROR_GROUND.replace("chalk", "varnish")
              + MIRROR_BALLS + MIRROR_LIGHTS)
MISTAKES = [
    ("reflected.weight = weight", "reflected.weight = incoming->weight",
     "Mirrors have no colour, and varnish reflects all: take the weight that you are given, not the incoming one."),
    ("reflected.weight = weight", "reflected.weight = weight * incoming->weight",
     "Second reflections are too dark: the incoming weight is in the one that you are given."),
    ("    ++reflected.depth;\n", "",
     "Rays go on beyond the depth limit: each bounce adds 1 to the depth."),
    ("++reflected.depth", "reflected.depth += 2",
     "The depth limit comes too early: each bounce adds 1 to the depth."),
    (RAY, "reflected.ray.origin = offset_ray_origin(surface, surface->normal);",
     "The ray goes on in its old direction: use reflected_ray."),
    (RAY, "reflected.ray.direction = reflect(incoming->ray.direction, surface->normal);",
     "The ray has a new direction and starts where the old one started: it starts at the surface."),
]


def check(attempt):
    attempt.expect_each([*MIRROR_SCENES, (ONE_BOUNCE, "mirrors on varnish, one bounce")], traced)
