# SPDX-License-Identifier: MIT
"""Each block shows the course's colour of its first pixel, at sizes that blocks do not divide too; and shadow rays, of
which each first hit has one a light, become as few as blocks."""
import json

from exercises import expect

BLOCK = 4
FLOOR = """
[camera]
position = [0, 3, 0]
look_at = [0, 0, -1]
[materials.floor]
type = "diffuse"
[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "floor"
[[lights]]
type = "directional"
direction = [0, -1, 0]
"""


def check(attempt):
    for width, height in ((160, 96), (62, 41)):
        course = attempt.render(size=(width, height), original=True)
        draft = attempt.render(size=(width, height))
        expect((course != draft).any(), "the picture is the course's: no pixel shows another's colour")
        blocks = course[::BLOCK, ::BLOCK].repeat(BLOCK, axis=0).repeat(BLOCK, axis=1)[:height, :width]
        attempt.expect_same(draft, blocks, f"blocks of {BLOCK} in {width}x{height}",
                            tolerance=1e-6, strays=0)
    stats = attempt.scratch / "stats.json"
    attempt.render("--stats", stats, scene=FLOOR, size=(160, 96))
    shadow = json.loads(stats.read_text())["rays"]["shadow"]
    expect(shadow == 160 * 96 // BLOCK ** 2, f"{shadow} shadow rays: expected one for each of the "
           f"{160 * 96 // BLOCK ** 2} blocks")
