#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""node_visits.py BUILD: how many nodes of the tree a primary ray of stages 09 and 10 looks into, by their solved heat maps. No
picture shows it where a walk does needless work, and a clock is no judge."""
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "stages"))
from exercises import Attempt  # noqa: E402

HOT, SIZE = 64, (160, 96)  # a pixel that has more shows no more
# Stage, methods, and the nodes a pixel, as measured: fewer are welcome.
CASES = [("09_tree", [], 3.29), ("10_packets", ["width=4"], 6.29), ("10_packets", ["width=16"], 9.97),
         ("10_packets", ["width=16", "walk=packet"], 6.30)]


def visits(build, stage, methods, scratch):
    exercise = ROOT / "stages" / stage / "exercises/1_heat_map"
    attempt = Attempt(build, exercise, exercise / "exercise.cl", "solution", scratch)
    options = [word for method in methods for word in ("--method", method)]
    return attempt.render("--device", "pocl", *options, size=SIZE).sum(axis=-1).mean() * HOT / 3


def main():
    build = pathlib.Path(sys.argv[1])
    failed = False
    for stage, methods, expected in CASES:
        with tempfile.TemporaryDirectory() as scratch:
            found = visits(build, stage, methods, pathlib.Path(scratch))
        failed |= found > 1.01 * expected
        print(f"{' '.join([stage] + methods)}: {found:.2f} nodes a ray, expected at most {expected:.2f}")
    sys.exit(failed)


if __name__ == "__main__":
    main()
