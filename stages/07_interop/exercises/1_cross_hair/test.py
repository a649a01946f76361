# SPDX-License-Identifier: MIT
"""Of what the course draws: the marked pixels the other way round, all others as they are, in pictures of even and odd
size; and of one that is brighter than a screen shows."""
import numpy as np
from exercises import scene_text

ARM = 12
SCENE = scene_text("07_interop.toml")
BRIGHT = SCENE.replace("intensity = ", "intensity = 1")  # 10.8 and 18


def check(attempt):
    for scene, width, height in ((SCENE, 160, 96), (BRIGHT, 63, 41)):
        course = attempt.render(scene=scene, size=(width, height), original=True)
        x, y = np.meshgrid(np.arange(width) - width // 2, np.arange(height) - height // 2)
        marked = ((x == 0) & (abs(y) <= ARM)) | ((y == 0) & (abs(x) <= ARM))
        expected = np.where(marked[..., None], 1 - np.clip(course, 0, 1), course)
        attempt.expect_same(attempt.render(scene=scene, size=(width, height)), expected,
                            f"the cross-hair in {width}x{height}", tolerance=1e-6, strays=0)
