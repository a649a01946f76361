# SPDX-License-Identifier: MIT
"""A cavity in clear glass is a ball of air within it, which the course can draw. Where nothing is bent, the way through
a shell is a difference of two chords."""
import re
import numpy as np
from exercises import dot, rays, scene_text

HOLLOW = 0.85
ABSORPTION = np.array([0.2, 1.1, 2.5])

SHELL = f"""
[camera]
position = [0.4, 0.6, 3]
look_at = [0, 0, 0]
fov = 50
[background]
color = [1, 1, 1]
[materials.glass]
type = "dielectric"
ior = 1
absorption = {list(ABSORPTION)}
[[spheres]]
center = [0, 0, 0]
radius = 1
material = "glass"
"""


def with_cavities(scene):
    """Another ball within each ball of glass."""
    def cavity(ball):
        inner = f"{ball[1]}radius = {HOLLOW * float(ball[2])}\nmaterial = \"cavity\"\n"
        return ball[0] + inner
    filled = re.sub(r'(\[\[spheres\]\]\ncenter = .*\n)radius = (.*)\nmaterial = "\w+_glass"\n', cavity, scene)
    return filled + '[materials.cavity]\ntype = "dielectric"\nior = 1\n'


def chord(eye, direction, radius):
    nearest = -dot(eye, direction)
    return 2 * np.sqrt(np.maximum(radius ** 2 - dot(eye, eye) + nearest ** 2, 0))


def check(attempt):
    clear = re.sub(r"absorption = .*", "", scene_text("04_refraction_beer.toml"))
    attempt.expect_same(attempt.render(scene=clear), attempt.render(scene=with_cavities(clear), original=True),
                        "hollow balls of clear glass")
    eye, direction = rays(SHELL)
    way = chord(eye, direction, 1) - chord(eye, direction, HOLLOW)
    attempt.expect_same(attempt.render("--method", "fresnel=none", scene=SHELL), np.exp(-ABSORPTION * way[..., None]),
                        "what a shell absorbs that does not bend light")
