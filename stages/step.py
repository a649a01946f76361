#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""step.py BUILD: walks through the stages in the terminal: what each is about, how much it adds, and its picture, two
pixels to a letter. Goes on at the Enter key, or at once where nobody can press it."""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import OpenImageIO as oiio

import difference

WIDTH = 96


def about(stage):
    """The comment at the head of its main.cpp, up to the first empty line."""
    head = re.match(r"// SPDX.*\n((?:// .*\n)+)", (stage / "main.cpp").read_text())[1]
    return re.sub(r"^// ?", "", head, flags=re.MULTILINE).strip()


def letters(file):
    """Upper half blocks: its colour is the upper pixel's, what is behind it the lower one's."""
    pixels = oiio.ImageInput.open(str(file)).read_image(oiio.UINT8)
    for upper, lower in zip(pixels[0::2], pixels[1::2]):
        pairs = zip(upper[:, :3].tolist(), lower[:, :3].tolist())
        yield "".join("\033[38;2;{};{};{}m\033[48;2;{};{};{}m▀".format(*a, *b) for a, b in pairs) + "\033[0m"


def draw(program):
    with tempfile.TemporaryDirectory() as scratch:
        file = Path(scratch) / "picture.png"
        size = f"{WIDTH}x{WIDTH * 3 // 5 // 2 * 2}"
        done = subprocess.run([program, "--size", size, "--samples", "4", "--display", "none", "--out", file],
                              capture_output=True, text=True)
        if done.returncode:
            print(done.stderr, end="", file=sys.stderr)
            sys.exit(done.returncode)
        print(*letters(file), sep="\n")


def main():
    build = Path(sys.argv[1])
    before = None
    for stage in difference.stages():
        print(f"\n{stage.name}\n{about(stage)}\n")
        draw(build / "stages" / stage.name)
        if before:
            added, _ = difference.counts(difference.difference(before, stage))
            print(f"\n{added} lines more than {before.name}: ./stagelight diff {before.name[:2]} {stage.name[:2]}")
        print(f"To read: stages/{stage.name}/kernel.cl and docs/chapters/{stage.name}.md")
        before = stage
        if sys.stdin.isatty() and stage != difference.stages()[-1]:
            input("Enter goes on ")


try:
    main()
except (KeyboardInterrupt, EOFError):
    print()
