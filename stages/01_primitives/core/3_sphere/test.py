# SPDX-License-Identifier: MIT
"""From outside, from inside, with a sphere behind the eye, and without planes or spheres."""
from exercises import first_hits

EYE = """
[camera]
position = [0, 1, 4]
look_at = [0, 0.8, 0]
fov = 70
[background]
color = [0.2, 0.1, 0]
"""
BALLS = """[[spheres]]
center = [-0.6, 0.9, 0.5]
radius = 0.9
[[spheres]]
center = [1.1, 0.5, 0]
radius = 0.6
[[spheres]]
center = [2, 1.2, 6]
radius = 0.7
"""
AROUND = """[[spheres]]
center = [0.5, 1, 3]
radius = 2.5
"""
GROUND = """[[planes]]
normal = [0, 1, 0]
point = [0, 0, 0]
"""

CHORD = """if (half_chord_squared < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(half_chord_squared);"""
MISTAKES = [
    ("inside ? nearest + half_chord : nearest - half_chord", "nearest - half_chord",
     "The sphere around the eye is missing. From inside, the near wall is behind you: then take the far one."),
    ("inside ? nearest + half_chord : nearest - half_chord", "nearest + half_chord",
     "You see the far wall of each sphere: of the two roots, the smaller one that is above zero is the first wall."),
    (CHORD, "const float half_chord = sqrt(fabs(half_chord_squared));",
     "Rays that pass a sphere hit it all the same: where the root's argument is negative, there is no hit."),
    ("center - ray.origin", "ray.origin - center",
     "The way between origin and centre has the wrong sign: you see the spheres behind the eye."),
    ("distance > 0.0f ? distance : INFINITY", "distance",
     "You see a sphere behind the eye: a negative distance is no hit."),
    ("radius * radius - dot(", "radius - dot(",
     "Your spheres have the wrong size: Pythagoras wants the radius squared."),
    ("sqrt(half_chord_squared)", "half_chord_squared",
     "Your spheres are too flat or too long: half of the chord is the root of that difference."),
    ("return distance > 0.0f ? distance", "return nearest > 0.0f ? nearest",
     "Your spheres are flat discs: you return the point nearest the centre. Go back by half the chord."),
    ("nearest * ray.direction", "ray.direction",
     "Your spheres are in the wrong place: the perpendicular leaves from the point nearest the centre."),
]


def check(attempt):
    attempt.expect_each([
        (EYE + BALLS + AROUND + GROUND, "spheres, one behind the eye and one around it"),
        (EYE + BALLS + GROUND, "spheres, one of them behind the eye"),
        (EYE + BALLS, "spheres without a plane"),
        (EYE + GROUND, "a plane without spheres"),
    ], first_hits)
