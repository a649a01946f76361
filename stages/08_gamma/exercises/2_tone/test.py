# SPDX-License-Identifier: MIT
"""The curve by its formula on what the course draws, in double; that white is where it should be, and that hues stay."""
import numpy as np
from exercises import dot, expect

SCENE = "02_shading_shadows.toml"
LUMINANCE, EXPOSURE, WHITE = np.array([0.2126, 0.7152, 0.0722]), 4, 6


def check(attempt):
    light = attempt.render(scene=SCENE, original=True)
    drawn = attempt.render(scene=SCENE)
    exposed = EXPOSURE * light
    luminance = dot(exposed, LUMINANCE)
    wanted = luminance * (1 + luminance / WHITE ** 2) / (1 + luminance)
    found = dot(drawn, LUMINANCE)
    attempt.expect_same(found[..., None].repeat(3, -1), wanted[..., None].repeat(3, -1), "the luminance", tolerance=1e-5,
                        strays=0)
    hue = np.abs(drawn * luminance[..., None] - exposed * found[..., None]).max()
    expect(hue < 1e-4, f"the colours of a pixel are no longer in proportion: by {hue:.3g}")
    # A wall of luminance WHITE / EXPOSURE, lit head-on, becomes 1.
    wall = f"""
[camera]
position = [0, 0, 1]
look_at = [0, 0, 0]
[[planes]]
normal = [0, 0, 1]
point = [0, 0, 0]
[[lights]]
type = "directional"
direction = [0, 0, -1]
intensity = {WHITE / EXPOSURE}
"""
    white = attempt.render(scene=wall, size=(8, 8))
    expect(np.abs(white - 1).max() < 1e-5, f"light of {WHITE} after exposure should become 1, and is {white[4, 4, 0]:.4g}")
