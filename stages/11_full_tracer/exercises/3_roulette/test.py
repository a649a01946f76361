# SPDX-License-Identifier: MIT
"""Without a systematic error: over many samples of many pixels, the mean difference from the picture of all rays is as small as
chance leaves it. And with far fewer rays."""
import json
import numpy as np
from exercises import expect

SIZE, SAMPLES = (80, 48), 64
SCENE = """
[camera]
position = [0, 1.2, 4]
look_at = [0, 0.8, 0]
fov = 55
[background]
color = [0.8, 0.6, 0.4]
[materials.glass]
type = "dielectric"
ior = 1.6
absorption = [0.1, 0.3, 0.6]
[materials.mirror]
type = "mirror"
color = [0.5, 0.7, 0.9]
[materials.floor]
type = "glossy"
color = [0.9, 0.8, 0.5]
specularity = 0.15
[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
material = "floor"
[[spheres]]
center = [-0.9, 0.9, 0]
radius = 0.9
material = "glass"
[[spheres]]
center = [1.1, 0.9, -0.3]
radius = 0.9
material = "mirror"
[[lights]]
type = "point"
position = [1, 4, 3]
intensity = 14
"""


def check(attempt):
    def render(original):
        stats = attempt.scratch / "stats.json"
        picture = attempt.render("--samples", SAMPLES, "--depth", 10, "--method", "depth=fixed", "--stats", stats, scene=SCENE,
                                 size=SIZE, original=original)
        counts = json.loads(stats.read_text())["rays"]
        return picture, counts["reflection"] + counts["refraction"]

    picture, rays = render(original=False)
    all_rays, number = render(original=True)
    difference = (picture - all_rays).reshape(-1, 3)
    mean, noise = difference.mean(axis=0), difference.std(axis=0) / np.sqrt(len(difference))
    expect((np.abs(mean) < 4 * noise + 1e-5).all(), f"the mean is off by {np.abs(mean).max():.2g}, and chance explains no more "
           f"than {noise[np.abs(mean).argmax()]:.2g}: what the survivors carry does not make up for the others")
    expect(noise.max() < 0.001, f"too much noise: {noise.max():.2g} in the mean of all pixels")
    expect(rays < 0.8 * number, f"{rays} reflected and refracted rays of {number} were traced: expected less than 80 %")
