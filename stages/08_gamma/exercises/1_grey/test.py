# SPDX-License-Identifier: MIT
"""Luminance by its definition, of what the course draws; and of a picture that is brighter than a screen shows, where
encoded values would be cut."""
from exercises import dot, scene_text

SCENE = scene_text("04_refraction_beer.toml")
BRIGHT = SCENE.replace("intensity = ", "intensity = 5")  # 50 to 59 times as much


def check(attempt):
    for scene, what in ((SCENE, "in grey"), (BRIGHT, "bright light in grey")):
        light = attempt.render(scene=scene, original=True)
        grey = dot(light, [0.2126, 0.7152, 0.0722])[..., None]
        attempt.expect_same(attempt.render(scene=scene), grey.repeat(3, axis=-1), what,
                            tolerance=1e-5 * (1 + light.max()), strays=0)
