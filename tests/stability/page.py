# SPDX-License-Identifier: MIT
"""page.py RESULTS PROGRAM SCENES DOCS: writes DOCS/index.md, a page of what the stability suite found (its JSON is in
RESULTS), with a plot for each sweep and the gallery of failures, each drawn by PROGRAM, a stage's program, with one
option that is not the default."""
import json
import math
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402 (the backend comes first)

matplotlib.rcParams["svg.hashsalt"] = "stagelight"  # the same page from the same figures
matplotlib.rcParams["svg.fonttype"] = "none"  # letters, not their outlines
DEVICES = {"pocl": ("PoCL", "-"), "llvmpipe": ("rusticl", ":")}
SMALLEST = 1e-12  # an error of 0 has no place on a logarithmic axis

# Title, scene, the option that fails, what is seen.
GALLERY = [
    ("Spheres far away, seen", "failures/far_spheres.toml", ["--method", "sphere=textbook"],
     "b² and 4c are nearly one and the same: what is left is noise."),
    ("A small mesh", "failures/small_mesh.toml", ["--method", "triangle=threshold"],
     "The determinant shrinks with the square of a triangle's size: the mesh vanishes."),
    ("A large scene", "failures/large_room.toml", ["--method", "origin=fixed"],
     "A thousandth of a unit is less than what coordinates are rounded by: surfaces shadow themselves."),
    ("A small scene", "failures/small_room.toml", ["--method", "origin=fixed"],
     "A thousandth of a unit is as much as the whole scene: shadows and reflections miss what is near."),
    ("Light in glass", "04_interior.toml", ["--method", "interior=paper"],
     "One way through, and no reflection inside: whatever is in the glass, or behind, is wrong."),
    ("Glass without reflection", "04_interior.toml", ["--method", "fresnel=none"],
     "Nothing but total internal reflection is left."),
    ("Glass that absorbs nothing", "04_interior.toml", ["--method", "transmission=none"],
     "The colour of glass comes from the way through it."),
    ("Mirrors cut short", "03_mirrors.toml", ["--depth", "2"], "What needs a third bounce is black."),
    ("Texels by the wrong curve", "08_decode.toml", ["--method", "decode=2.2"], "Wrong in the dark."),
    ("Shadows of facets", "failures/shadow_terminator.toml", ["--method", "terminator=none"],
     "Where the normals still face the light and the facet does not, the mesh shadows itself."),
]


def read_sweeps(folder):
    sweeps = {}
    for file in sorted(folder.glob("*.json")):
        sweep = json.loads(file.read_text(encoding="utf-8"))
        sweeps.setdefault(sweep["name"], {})[sweep["device"]] = sweep
    order = ["sphere", "triangle", "box", "origin", "terminator", "fresnel", "refraction", "interior", "transmission", "sphere_map",
             "filtering", "decode", "encode", "light", "depth", "normals", "normalise", "math"]
    kind = lambda name: next(iter(sweeps[name].values()))["kind"]  # noqa: E731
    return {name: sweeps[name] for name in sorted(sweeps, key=lambda n: (
        order.index(kind(n)) if kind(n) in order else len(order), n))}


def number(x):
    return f"{x:.3g}" if 0.001 < x < 1000 else f"{x:.1e}".replace("e+0", "e").replace("e-0", "e-").replace("e+", "e")


def draw_sweep(by_device, file):
    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    first = next(iter(by_device.values()))
    for device, sweep in by_device.items():
        label, line = DEVICES[device]
        for index, method in enumerate(sweep["methods"]):
            color = f"C{index}"
            points = [(x, math.inf if e is None else max(e, SMALLEST)) for x, e in method["points"]]
            finite = [e for _, e in points if math.isfinite(e)] + [sweep["limit"]]
            top = 10 * max(finite)
            axes.plot([x for x, _ in points], [min(e, top) for _, e in points], line, color=color, linewidth=1.3,
                      marker=".", markersize=3, label=f"{method['name']}" if device == "pocl" else None)
            if method["fails_at"] is not None:
                at = next(min(e, top) for x, e in points if x == method["fails_at"])
                axes.plot(method["fails_at"], at, "X", color=color, markersize=8, markeredgecolor="black")
    axes.axhline(first["limit"], color="red", linewidth=0.8, linestyle="--")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(first["x_label"])
    axes.set_ylabel(first["y_label"])
    axes.legend(fontsize=8)
    axes.grid(alpha=0.3)
    figure.savefig(file, metadata={"Date": None})
    plt.close(figure)


def fails(sweep, name):
    method = next((m for m in sweep["methods"] if m["name"] == name), None)
    if method is None:
        return "–"
    return f"holds to {number(method['points'][-1][0])}" if method["fails_at"] is None else number(method["fails_at"])


def sweep_lines(name, by_device):
    first = next(iter(by_device.values()))
    stated = f"; stated: {first['stated']}" if first["stated"] else ""
    lines = [f"## {first['title']}", "", f"![{first['title']}]({name}.svg)", "",
             f"Fails above {first['limit']:.3g} ({first['y_label']}){stated}. Where each method first fails, by {first['x_label']}:", "",
             "| method | " + " | ".join(DEVICES[device][0] for device in by_device) + " |",
             "|---|" + "---|" * len(by_device)]
    names = list(dict.fromkeys(m["name"] for sweep in by_device.values() for m in sweep["methods"]))
    for method in names:
        lines.append(f"| {method} | " + " | ".join(fails(sweep, method) for sweep in by_device.values()) + " |")
    return lines + [""]


def draw_picture(program, scene, options, file):
    size = ["--size", "320x192"]
    subprocess.run([program, scene, *size, *options, "--out", file], check=True, stdout=subprocess.DEVNULL)


def gallery_lines(program, scenes, docs):
    lines = ["## Gallery of failures", "",
             "Left by the defaults, right with one option that is not: `./stagelight run 11 scenes/…`.", ""]
    for index, (title, scene, options, seen) in enumerate(GALLERY):
        good, bad = f"gallery_{index:02}_good.png", f"gallery_{index:02}_bad.png"
        draw_picture(program, scenes / scene, [], docs / good)
        draw_picture(program, scenes / scene, options, docs / bad)
        command = f"scenes/{scene} {' '.join(options)}"
        lines += [f"### {title}", "", f"`{command}`: {seen}", "",
                  f"| default | {' '.join(options)} |", "|---|---|",
                  f"| ![{title}, by the defaults]({good}) | ![{title}, {' '.join(options)}]({bad}) |", ""]
    return lines


def main():
    results, program, scenes, docs = (pathlib.Path(argument) for argument in sys.argv[1:])
    sweeps = read_sweeps(results)
    for old in [*docs.glob("*.svg"), *docs.glob("gallery_*.png")]:
        old.unlink()
    lines = ["<!-- Written by ./stagelight stability from the figures of tests/stability: do not edit. -->",
             "# Where methods fail", "",
             "Each choice of the tracer has several methods (`--method list`). Each sweep pushes one quantity until "
             "methods break, or to its end: then they \"hold\". They are compared with long double or a closed form; "
             "\"–\" is what a device cannot do, or was not tried there. `ctest -L stability` asserts that the sound "
             "methods hold where it is said, and that the poor ones fail, so that this page stays true. In the plots a "
             "cross is the first point above the limit (red); solid lines are PoCL's, dotted ones rusticl's.", ""]
    for name, by_device in sweeps.items():
        draw_sweep(by_device, docs / f"{name}.svg")
        lines += sweep_lines(name, by_device)
    lines += gallery_lines(program, scenes, docs)
    (docs / "index.md").write_text("\n".join(lines).rstrip() + "\n", encoding="utf-8")
    print(f"wrote {docs}/index.md, {len(sweeps)} plots and {2 * len(GALLERY)} pictures")


main()
