# SPDX-License-Identifier: MIT
"""recorded.py OUT: keeps what `bench` and `chart` have measured (OUT/bench.json, OUT/chart/chart.json) in
docs/recorded, with what it was measured of: figures older than their sources are an error when they are read."""
import datetime
import hashlib
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "docs" / "recorded"
sys.path.append(str(ROOT / "stages"))

import difference  # noqa: E402


def sources_of(stage, scene):
    """Of what a picture is made of on the device: a stage's kernel without comments, and the scene."""
    files = {}
    difference.included(ROOT / "stages" / stage / "kernel.cl", files)
    code = [re.sub(r"\s+", " ", difference.code_of(line)).strip() for file in sorted(files) for line in files[file]]
    text = "\n".join(filter(None, code)) + (ROOT / "scenes" / f"{scene}.toml").read_text()
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def scenes_of(report):
    """Name and what was measured."""
    for scene in report["scenes"]:
        name = scene.get("name") or scene["scene"].removesuffix(".toml")
        yield name, scene


def sources(report):
    last = difference.stages()[-1].name
    return {name: [sources_of(stage, name) for stage in dict.fromkeys((scene["own"]["stage"] if "own" in scene else last,
                                                                       last))]
            for name, scene in scenes_of(report)}


def read(name):
    """A file of docs/recorded; costs.json has its scenes by name."""
    report = json.loads((FOLDER / name).read_text())
    stale = [scene for scene, of in sources(report).items() if of != report["sources"][scene]]
    if stale:
        print(f"stagelight: docs/recorded/{name} is older than the kernels or scenes of {', '.join(stale)}: "
              "./stagelight docs record, on a machine that does nothing else", file=sys.stderr)
        sys.exit(1)
    return report | ({"scenes": dict(scenes_of(report))} if name == "costs.json" else {})


def keep(file, name):
    report = json.loads(file.read_text())
    for _, scene in scenes_of(report):
        for run in (scene.get("own", {}), scene.get("full_tracer", {})):
            run.pop("milliseconds", None)  # every frame's; the median stays
    report |= {"date": datetime.date.today().isoformat(), "sources": sources(report)}
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / name).write_text(json.dumps(report, separators=(",", ":")) + "\n")


if __name__ == "__main__":
    out = Path(sys.argv[1])
    keep(out / "bench.json", "costs.json")
    keep(out / "chart" / "chart.json", "chart.json")
