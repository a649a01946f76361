# SPDX-License-Identifier: MIT
"""A packet looks into what any of its rays would, and packets that walk alone are counted alone. What a ray by itself looks into is
known from the exercise of stage 09, which is solved there."""
import numpy as np
from exercises import ROOT, Attempt, expect

HOT, SIZE = 64, (160, 96)
BY_ITSELF = ROOT / "stages/09_tree/exercises/1_heat_map"


def check(attempt):
    shared = attempt.render("--method", "width=16", size=SIZE).sum(axis=-1) * HOT / 3
    narrow = attempt.render("--method", "width=4", size=SIZE).sum(axis=-1) * HOT / 3
    counts = np.rint(shared)
    expect(np.abs(shared - counts).max() < 0.01 and counts.min() >= 1, "each ray looks into the root, and nodes are whole numbers")
    single = by_itself(attempt).render("--method", "width=1", size=SIZE).sum(axis=-1) * HOT / 3
    for picture, width in ((narrow, 4), (shared, 16)):
        fewer = (picture < single - 0.1).mean()
        expect(fewer <= 0.01, f"{width} rays at a time: a packet looks into what any of its rays would, but {fewer:.1%} of the "
               "pixels have fewer nodes than by themselves")
    packets = shared.reshape(12, 2, 4, 20, 2, 4)
    expect((np.ptp(packets, axis=(2, 5)) < 0.1).all(), "pixels of one packet must have one count")
    blocks = np.ptp(packets, axis=(1, 2, 4, 5))
    expect((blocks > 0.1).mean() > 0.05, "packets that walk alone must be counted alone: in nearly all blocks of four all have "
           "one count")


def by_itself(attempt):
    """Stage 10 draws one ray at a time with the kernel of stage 09."""
    single = Attempt(attempt.program.parent.parent, BY_ITSELF, BY_ITSELF / "exercise.cl", "solution",
                     attempt.scratch / "by_itself")
    single.program = attempt.program
    return single
