#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A stage's lesson as one page, which a compiler takes as it is: show.py STAGE [FUNCTION].

Lines that the stage before had not are marked with +. The lesson is what difference.py makes of the kernels."""
import difflib
import itertools
import re
import sys

sys.dont_write_bytecode = True  # a folder in stages/ is a stage
from difference import code_of, compared, lesson, names_of, number_of, pieces_of, stages  # noqa: E402


def marked(old, new):
    """Each of the new lines, after + where the old ones had it not, else after a blank."""
    marks = [" "] * len(new)
    for kind, _, _, begin, end in difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if kind != "equal":
            marks[begin:end] = ["+"] * (end - begin)
    return [f"{mark} {line}".rstrip() for mark, line in zip(marks, new)]


def without_gaps(lines):
    """At most one empty line where something was left out, and none at either end."""
    kept = [line for line, before in zip(lines, ["", *lines]) if line.strip() or before.strip()]
    return kept[:-1] if kept and not kept[-1].strip() else kept


def without_head(lines):
    """What a file begins with says of the file: its licence, and what it is for."""
    return list(itertools.dropwhile(lambda line: line.startswith("//") and not line.startswith("// #"), lines))


def head_of(lines):
    """What it is for, after a colon."""
    text = " ".join(line[3:] for line in lines[:len(lines) - len(without_head(lines))] if "SPDX" not in line)
    return ": " + re.sub(r"^Introduced by stage [^:]*: ", "", text).split(". ")[0].rstrip(".") + "." if text else ""


def page(before, stage, function="", without=()):
    """Lines; with a function, of it alone, and none where the lesson has no such."""
    old, _ = compared(before, stage)
    for file, lines in lesson(stage, without).items():
        pieces = [without_gaps(piece) for piece in pieces_of(without_head(lines))]
        earlier = [without_gaps(piece) for piece in pieces_of(without_head(old.get(file, [])))]
        if function:
            pieces = [piece for piece in pieces if function in names_of(piece)]
            earlier = [piece for piece in earlier if function in names_of(piece)]
        if any(code_of(line) for piece in pieces for line in piece):
            yield f"  // {file}{head_of(lines)}"
            yield from marked(sum(earlier, []), sum(([*piece, ""] for piece in pieces), []))


def fail(text):
    print(f"show {' '.join(sys.argv[1:])}: {text}", file=sys.stderr)
    return 2


def main(arguments):
    by_number = {number_of(stage): stage for stage in stages()}
    wanted = arguments[0][:2] if arguments else ""
    stage = by_number.get(int(wanted)) if wanted.isdigit() else None
    if stage is None or len(arguments) > 2:
        return fail(f"expected a stage of {', '.join(each.name for each in by_number.values())}, and perhaps a function")
    before = by_number.get(number_of(stage) - 1)
    lines = list(page(before, stage, *arguments[1:]))
    if not lines:
        names = sorted(set().union(*(names_of(piece) for lines in lesson(stage).values() for piece in pieces_of(lines))))
        return fail(f"{stage.name} has no '{arguments[1]}'; there are: {', '.join(names)}")
    for line in lines:
        print(f"\033[32m{line}\033[0m" if line.startswith("+") and sys.stdout.isatty() else line)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
