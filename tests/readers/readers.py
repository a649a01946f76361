# SPDX-License-Identifier: MIT
"""readers.py TRACER OUT [OPTIONS]: our readers of meshes and pictures beside others'. TRACER is the full tracer's program;
OUT gets readers.json, and each mesh as both draw it: ours left, three.js's right. Prints the tables of docs/other-readers.md.
Ends with 1 where something is not as it should be."""
import argparse
import dataclasses
import json
import pathlib
import re
import shutil
import sys
import tempfile

import cases
import judge
import pictures

WELL = ("agrees", "known", "told", "neither")


@dataclasses.dataclass
class Mesh:
    """What was found of a file. The verdict is "agrees", "differs", "known" (it differs, and the note has the reason),
    "told" (a line says why there is no picture, as it should), "wrong line", "refused", "only ours" (three.js can't read it)
    or "neither"."""
    name: str
    verdict: str
    iou: float | None = None
    difference: float | None = None
    said: str = ""  # by us, or where only we draw it, by three.js
    note: str = ""

    def line(self):
        figures = f"{self.iou:.4f} | {self.difference:.4f}" if self.iou is not None else "| "
        return f"| {self.name} | {figures} | {self.verdict} | {self.note if self.verdict in WELL else self.said} |"


def last_line(text, folder):
    return text.splitlines()[-1].replace(f"{folder}/", "") if text else ""


def compare_mesh(three, tracer, name, files, folder, picture):
    """`files` are ours and three.js's."""
    ours, theirs = files
    try:
        their_pixels, scale, position = three.draw(theirs)
    except RuntimeError as error:
        drawn = judge.draw_mesh(tracer, ours, 1.0, [0, 0, 0], folder)
        said = last_line(drawn.said, folder)
        return Mesh(name, "neither", said=said) if drawn.code else Mesh(name, "only ours", said=f"three.js: {error}")
    drawn = judge.draw_mesh(tracer, ours, scale, position, folder)
    judge.save_pair(picture, drawn.pixels, their_pixels)
    said = last_line(drawn.said, folder)
    if drawn.pixels is None:
        return Mesh(name, "refused", said=said)
    found = judge.compare(drawn.pixels, their_pixels)
    return Mesh(name, "agrees" if found.agrees else "differs", found.iou, found.difference, said)


def judge_case(three, tracer, case, folder, picture):
    written = case.write(folder)
    if case.message:
        drawn = judge.draw_mesh(tracer, written, 1.0, [0, 0, 0], folder)
        said = last_line(drawn.said, folder)
        is_right = drawn.code == 2 and re.search(case.message, said, re.IGNORECASE)
        return Mesh(case.name, "told" if is_right else "wrong line", said=said, note=said)
    files = written if isinstance(written, tuple) else (written, written)
    found = compare_mesh(three, tracer, case.name, files, folder, picture)
    if found.verdict == "differs" and case.known:
        found.verdict = "known"
    return dataclasses.replace(found, note=case.note)


def judge_cases(tracer, out, chosen):
    with judge.Three() as three:
        for case in chosen:
            with tempfile.TemporaryDirectory() as folder:
                yield judge_case(three, tracer, case, pathlib.Path(folder), out / (case.name.replace("/", "_") + ".png"))


MODELS = {".3ds", ".3mf", ".amf", ".dae", ".fbx", ".glb", ".gltf", ".lwo", ".obj", ".ply", ".stl"}


def judge_models(tracer, out, models):
    """Of a file that we refuse the line is what counts, and it is for a reader to judge."""
    with judge.Three() as three:
        for file in sorted(file for file in models.rglob("*") if file.suffix.lower() in MODELS):
            name = str(file.relative_to(models))
            with tempfile.TemporaryDirectory() as folder:
                found = compare_mesh(three, tracer, name, (file, file), pathlib.Path(folder),
                                     out / (name.replace("/", "_") + ".png"))
            yield dataclasses.replace(found, note=found.said)


@dataclasses.dataclass
class Picture:
    """The verdict is "agrees", "differs" or "refused"."""
    name: str
    verdict: str
    worst: int | None  # codes of 255
    wrong: float  # the share of texels that are off by more than is allowed
    said: str
    note: str

    def line(self):
        worst = "" if self.worst is None else self.worst
        return f"| {self.name} | {worst} | {100 * self.wrong:.3g} % | {self.verdict} | {self.note or self.said} |"


def judge_pictures(tracer, chosen):
    for kind in chosen:
        with tempfile.TemporaryDirectory() as folder:
            found = pictures.judge_picture(tracer, kind, pathlib.Path(folder))
        verdict = "refused" if found.worst is None else "differs" if found.wrong else "agrees"
        yield Picture(kind.name, verdict, found.worst, found.wrong, found.said.replace(folder + "/", ""), kind.note)


def show(head, rows):
    shown = []
    for row in rows:
        if not shown:
            print(head, flush=True)
        shown.append(row)
        print(row.line(), flush=True)
    return shown


def main():
    parser = argparse.ArgumentParser(prog="readers", description="our readers beside three.js and Pillow")
    parser.add_argument("tracer", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true", help="a few files of each format")
    parser.add_argument("--only", default="", metavar="PART", help="those with PART in their names")
    parser.add_argument("--models", type=pathlib.Path, metavar="FOLDER", help="a folder's meshes instead of our own")
    options = parser.parse_args()
    if options.models and not options.models.is_dir():
        parser.error(f"--models {options.models}: expected a folder")

    def choose(of):
        return [one for one in of if options.only in one.name and (one.quick or not options.quick)]

    shutil.rmtree(options.out, ignore_errors=True)
    options.out.mkdir(parents=True)
    meshes = judge_models(options.tracer, options.out, options.models) if options.models \
        else judge_cases(options.tracer, options.out, choose(cases.ALL))
    shown = show("| mesh | IoU | colour | | |\n|---|--:|--:|---|---|", meshes)
    if not options.models:
        shown += show("\n| picture | worst | wrong | | |\n|---|--:|--:|---|---|",
                      judge_pictures(options.tracer, choose(pictures.ALL)))
    found = json.dumps([dataclasses.asdict(row) for row in shown], indent=1)
    (options.out / "readers.json").write_text(found, encoding="utf-8")
    failed = [row.name for row in shown if row.verdict not in WELL]
    if not shown:
        parser.error(f"--only '{options.only}': no file's name has this in it")
    print(f"\n{len(shown) - len(failed)} of {len(shown)} files are read as they should be", flush=True)
    return int(bool(failed))


if __name__ == "__main__":
    sys.exit(main())
