# SPDX-License-Identifier: MIT
"""readers.py TRACER OUT [--quick] [--models FOLDER]: our readers of meshes and pictures beside others. TRACER is the full
tracer's program. OUT gets readers.json and the pictures of the pairs. Prints a table of the small files that cases.py
and pictures.py write; --quick draws a few of each. With --models, draws what both can read of a folder's meshes instead.
Ends with 1 where one differs from what it is to be."""
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


@dataclasses.dataclass
class Row:
    name: str
    verdict: str  # "agrees", "differs", "known" (it differs, and the note has the reason), "told" (a line
    # instead of a picture), "wrong line", or "only ours"
    iou: float | None
    difference: float | None
    said: str  # our last line, or three.js's where it has no picture
    note: str = ""

    def line(self):
        figures = f"{self.iou:.4f} | {self.difference:.4f}" if self.iou is not None else "| "
        return f"| {self.name} | {figures} | {self.verdict} | {self.note or self.said} |"


def last_line(text):
    return text.splitlines()[-1] if text else ""


def judge_pair(three, tracer, ours, theirs, folder, picture):
    """A Row without a name."""
    try:
        their_pixels, scale, position, _ = three.draw(theirs)
    except RuntimeError as error:
        drawn = judge.draw_mesh(tracer, ours, 1.0, [0, 0, 0], folder)
        if drawn.code:
            return Row("", "told", None, None, last_line(drawn.said), "three.js neither")
        return Row("", "only ours", None, None, f"three.js: {error}")
    drawn = judge.draw_mesh(tracer, ours, scale, position, folder)
    judge.save_pair(picture, drawn.pixels, their_pixels)
    if drawn.pixels is None:
        return Row("", "told", None, None, last_line(drawn.said))
    found = judge.compare(drawn.pixels, their_pixels)
    return Row("", "agrees" if found.agrees else "differs", found.iou, found.difference, last_line(drawn.said))


def judge_case(three, tracer, case, folder, picture):
    written = case.write(folder)
    ours, theirs = written if isinstance(written, tuple) else (written, written)
    if case.message:
        drawn = judge.draw_mesh(tracer, ours, 1.0, [0, 0, 0], folder)
        line = last_line(drawn.said)
        right = drawn.code == 2 and re.search(case.message, line, re.IGNORECASE)
        return Row(case.name, "told" if right else "wrong line", None, None, line.replace(str(folder) + "/", ""))
    row = judge_pair(three, tracer, ours, theirs, folder, picture)
    if row.verdict == "differs" and case.known:
        row = dataclasses.replace(row, verdict="known")
    said = row.said.replace(str(folder) + "/", "")
    return dataclasses.replace(row, name=case.name, said=said if row.verdict != "agrees" else "", note=case.note)


def judge_cases(tracer, out, chosen):
    with judge.Three() as three:
        for case in chosen:
            with tempfile.TemporaryDirectory() as folder:
                yield judge_case(three, tracer, case, pathlib.Path(folder), out / (case.name.replace("/", "_") + ".png"))


MODELS = {".3ds", ".3mf", ".amf", ".dae", ".fbx", ".glb", ".gltf", ".lwo", ".obj", ".ply", ".stl", ".wrl"}


def judge_models(tracer, out, models):
    files = sorted(file for file in models.rglob("*") if file.suffix.lower() in MODELS)
    with judge.Three() as three:
        for file in files:
            name = str(file.relative_to(models))
            with tempfile.TemporaryDirectory() as folder:
                row = judge_pair(three, tracer, file, file, pathlib.Path(folder), out / (name.replace("/", "_") + ".png"))
            yield dataclasses.replace(row, name=name)


def main():
    parser = argparse.ArgumentParser(description="our readers of meshes and pictures beside others")
    parser.add_argument("tracer", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true", help="a few files of each format")
    parser.add_argument("--models", type=pathlib.Path, help="a folder of mesh files to compare instead")
    parser.add_argument("--only", default="", help="files whose name has this in it")
    options = parser.parse_args()
    shutil.rmtree(options.out, ignore_errors=True)
    options.out.mkdir(parents=True)
    if options.models:
        rows = judge_models(options.tracer, options.out, options.models)
    else:
        chosen = [case for case in cases.ALL if options.only in case.name and (case.quick or not options.quick)]
        rows = judge_cases(options.tracer, options.out, chosen)
    print("| file | IoU | colour | | |\n|---|--:|--:|---|---|", flush=True)
    shown = []
    for row in rows:
        shown.append(row)
        print(row.line(), flush=True)
    (options.out / "readers.json").write_text(json.dumps([dataclasses.asdict(row) for row in shown], indent=1), encoding="utf-8")
    return int(any(row.verdict in ("differs", "wrong line", "only ours") for row in shown))


if __name__ == "__main__":
    sys.exit(main())
