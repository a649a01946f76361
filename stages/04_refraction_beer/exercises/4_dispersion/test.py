# SPDX-License-Identifier: MIT
"""Each channel is that of the course's picture of glass with that channel's index."""
import json
import numpy as np
from exercises import expect, scene_text

SCENE = "04_refraction_beer.toml"
DISPERSION = 0.05


def check(attempt):
    text = scene_text(SCENE)
    expected = np.stack([
        attempt.render(scene=text.replace("ior = 1.5", f"ior = {1.5 + shift}"), original=True)[..., channel]
        for channel, shift in enumerate((-DISPERSION, 0, DISPERSION))], axis=-1)
    attempt.render("--depth", 1)  # what the stack has no room for is written over the end of a short one
    stats = attempt.scratch / "stats.json"
    attempt.expect_same(attempt.render("--stats", stats), expected, "three channels, each with its index")
    rays = json.loads(stats.read_text())["rays"]
    traced = (rays["reflection"] + rays["refraction"]) / rays["primary"]
    expect(traced < 25, f"a pixel has {traced:.3g} reflected and refracted rays: expected below 25; are rays of one "
           "channel split in three again?")
