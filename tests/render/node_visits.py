#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""node_visits.py BUILD: how many nodes of the tree a primary ray of stages 09 and 10 looks into, by their solved heat maps. No
picture shows it where a walk does needless work, and a clock is no judge."""
import os
import pathlib
import shutil
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "stages"))
import exercises  # noqa: E402

if kernels := os.environ.get("STAGELIGHT_KERNELS"):  # ./stagelight mutate: those with a mistake
    exercises.copy_kernels = lambda folder: shutil.copytree(kernels, folder)

HOT, SIZE = 64, (160, 96)  # a pixel that has more shows no more
# Stage, methods, and the nodes a pixel, as measured. A beam's node counts for each of its packets: a walk that is another is
# as suspect with fewer as with more.
CASES = [("09_tree", [], 3.29), ("10_packets", ["width=4"], 6.29), ("10_packets", ["width=16"], 9.97),
         ("10_packets", ["width=16", "walk=packet"], 6.30)]


def visits(build, stage, methods, scratch):
    exercise = ROOT / "stages" / stage / "exercises/1_heat_map"
    attempt = exercises.Attempt(build, exercise, exercise / "exercise.cl", "solution", scratch)
    options = [word for method in methods for word in ("--method", method)]
    return attempt.render("--device", "pocl", *options, size=SIZE).sum(axis=-1).mean() * HOT / 3


def main():
    build = pathlib.Path(sys.argv[1])
    failed = False
    for stage, methods, expected in CASES:
        with tempfile.TemporaryDirectory() as scratch:
            found = visits(build, stage, methods, pathlib.Path(scratch))
        failed = failed or not 0.99 * expected < found < 1.01 * expected
        print(f"{' '.join([stage] + methods)}: {found:.2f} nodes a ray, expected {expected:.2f}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
