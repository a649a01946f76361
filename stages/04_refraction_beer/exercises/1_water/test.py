# SPDX-License-Identifier: MIT
"""Scaling all indices changes nothing: glass in water looks as the course draws thinner glass in air."""
import re
from exercises import scene_text

OUTSIDE = 1.33


def check(attempt):
    for scene, what in (("04_refraction_beer.toml", "glass"), ("04_interior.toml", "amber and bubble")):
        in_air = re.sub(r"ior = ([\d.]+)", lambda ior: f"ior = {float(ior[1]) / OUTSIDE}", scene_text(scene))
        attempt.expect_same(attempt.render(scene=scene), attempt.render(scene=in_air, original=True),
                            f"{what} under water")
