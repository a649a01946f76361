# SPDX-License-Identifier: MIT
"""generate.py BUILD: what the course's pages show that is made from the sources, into docs/generated (included in
pages) and docs/public (served as it is). What is up to date is left alone."""
import hashlib
import itertools
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
GENERATED = DOCS / "generated"
PUBLIC = DOCS / "public"
CHART = PUBLIC / "generated" / "chart"
sys.path += [str(ROOT / "stages"), str(ROOT / "tests" / "mutants")]

import difference  # noqa: E402
import exercises  # noqa: E402
import mutate  # noqa: E402
import recorded  # noqa: E402
import show  # noqa: E402


def fail(text):
    print(f"stagelight: docs: {text}", file=sys.stderr)
    sys.exit(1)


def fenced(language, text):
    return f"```{language}\n{text.rstrip()}\n```\n"


def details(summary, text):
    return f"<details><summary>{summary}</summary>\n\n{text}\n</details>\n"


# --- What changed between two stages

def show_difference(before, after):
    old, new = difference.lesson(before), difference.lesson(after)
    lines = difference.difference(before, after)
    added, removed = difference.counts(lines)
    parts = [f"{added} lines of code are new and {removed} are gone, by `./stagelight diff {before.name[:2]} "
             f"{after.name[:2]}`.\n"]
    for file in sorted(old.keys() | new.keys()):
        if file not in old:
            parts.append(details(f"<code>{file}</code>, new", fenced("c", "\n".join(new[file]))))
        elif file not in new:
            parts.append(f"<p><code>{file}</code> is gone.</p>\n")
        elif old[file] != new[file]:
            changed = difference.difflib.unified_diff(old[file], new[file], lineterm="")
            text = "\n".join(line for line in changed if not line.startswith(("---", "+++")))
            parts.append(details(f"<code>{file}</code>, changed", fenced("diff", text)))
    return "\n".join(parts)


def show_differences():
    for before, after in itertools.pairwise(difference.stages()):
        write(f"difference_{before.name[:2]}_{after.name[:2]}.md", show_difference(before, after))


# --- What chapters list: no more of a kernel than their stage has learnt

def show_lessons():
    for stage in difference.stages():
        for file, lines in difference.lesson(stage, with_regions=True).items():
            target = GENERATED / "lessons" / stage.name / file
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text("\n".join(show.without_gaps(lines)) + "\n")


# --- What a stage costs

def milliseconds(ms):
    return f"{ms:.0f}" if ms >= 100 else f"{ms:.1f}"


def show_costs():
    costs = recorded.read("costs.json")
    for stage in difference.stages():
        scene = costs["scenes"][stage.name]
        own, full = scene["own"], scene.get("full_tracer")  # the last stage is the full tracer
        rows = {"a frame, milliseconds": lambda run: milliseconds(run["median"]),
                "building the kernel, milliseconds": lambda run: milliseconds(run["build"]["kernel_milliseconds"]),
                **{f"{kind} rays a frame": lambda run, kind=kind: f"{run['rays'][kind]:,}"
                   for kind in ("primary", "shadow", "reflection", "refraction") if own["rays"][kind]},
                "million rays a second": lambda run: f"{run['million_rays_per_second']['all']:.1f}",
                "on the device, bytes": lambda run: f"{run['bytes_on_device']['total']:,}",
                "error inside surfaces, at the most": lambda run: f"{run['error']['worst_interior']:.1e}",
                "root of the mean squared error": lambda run: f"{run['error']['rmse']:.1e}"}
        runs = {"this stage": own} | ({"the full tracer, same scene": full} if full else {})
        lines = [f"| | {' | '.join(runs)} |", "|---|" + "--:|" * len(runs)]
        lines += [f"| {what} | {' | '.join(map(of, runs.values()))} |" for what, of in rows.items()]
        lines += ["", f"The default scene at its own size, one sample a pixel; medians, on {costs['device']['name']} "
                  f"({costs['device']['platform']}, {costs['device']['driver']}), recorded on {costs['date']} by "
                  "`./stagelight docs record`. Errors are against the reference in double, in linear light.", ""]
        write(f"cost_{stage.name[:2]}.md", "\n".join(lines))


# --- The exercises

def solution_of(exercise):
    """Of a core exercise, what the course has there, as far as the stage has learnt it; of a method that is not the
    default, all."""
    file = exercise / "exercise.cl"
    if not exercises.is_core(exercise):
        return "\n".join(line for _, line in exercises.part_of(file, "solution"))
    lesson = difference.lesson(exercise.parents[1], with_regions=True)
    parts = []
    for target, name, _ in exercises.regions_of(file, "solution"):
        lines = lesson.get(target) or (ROOT / target).read_text().splitlines()
        text = "\n".join(show.without_gaps(lines)) + "\n"
        start, end = exercises.span_of(text, file, target, name)
        lines = [line for line in text[start:end].splitlines() if "#region" not in line and "#endregion" not in line]
        parts.append("\n".join([f"// {target}", *lines]))
    return "\n\n".join(parts)


def show_exercise(exercise):
    command = f"./stagelight exercise {exercise.parts[-3][:2]} {exercises.address_of(exercise)}"
    return "\n".join([
        (exercise / "README.md").read_text(),
        f"The first time, `{command}` makes your file, `{exercises.copy_of(exercise).relative_to(ROOT)}`; then it builds, "
        f"draws and tests what you wrote. `{command} --solution` shows where it leads.\n",
        details("A solution", fenced("c", solution_of(exercise)))])


def show_exercises():
    for stage in difference.stages():
        chosen = exercises.exercises(stage.name)
        core = [exercise for exercise in chosen if exercises.is_core(exercise)]
        parts = list(map(show_exercise, chosen))
        if core:
            parts.insert(0, "First write this chapter's own functions, one after the other: "
                            f"{', '.join(f'`{exercises.title_of(exercise)}`' for exercise in core)}. In each the course's "
                            "function is gone, and a test tells you what your picture has wrong. What follows them is "
                            "new.\n")
        write(f"exercises_{stage.name[:2]}.md", "\n".join(parts))


# --- Pictures

def wanted_pictures():
    """By name, of all docs/pictures/*.toml."""
    wanted = {}
    for file in sorted((DOCS / "pictures").glob("*.toml")):
        for name, picture in tomllib.loads(file.read_text()).items():
            if unknown := picture.keys() - {"stage", "scene", "options", "mutant", "regions", "part"}:
                fail(f"{file.relative_to(ROOT)}: {name}: {', '.join(unknown)}: expected stage, scene, options, mutant, "
                     "regions or part")
            if picture.get("part", "solution") not in ("stub", "solution"):
                fail(f"{file.relative_to(ROOT)}: {name}: part {picture['part']}: expected stub or solution")
            if name in wanted:
                fail(f"{file.relative_to(ROOT)}: there is a picture {name} already")
            wanted[name] = picture
    return wanted


def planted_kernels(folder, mutant):
    mutants = {m["name"]: m for m in tomllib.loads((ROOT / "tests/mutants/mutants.toml").read_text())["mutants"]}
    if mutant not in mutants:
        fail(f"tests/mutants/mutants.toml has no {mutant}")
    exercises.copy_kernels(folder)
    (folder / mutants[mutant]["file"]).write_text(mutate.mutated(ROOT, mutants[mutant]))


def draw(build, name, picture):
    with tempfile.TemporaryDirectory() as scratch:
        kernels = Path(scratch) / "kernels"
        if "mutant" in picture:
            planted_kernels(kernels, picture["mutant"])
        elif "regions" in picture:
            exercises.copy_kernels(kernels)
            exercises.replace_regions(kernels, ROOT / picture["regions"], picture.get("part", "solution"))
        command = [build / "stages" / picture["stage"], *([ROOT / picture["scene"]] if "scene" in picture else []),
                   *picture.get("options", []), "--display", "none", "--out", PUBLIC / "generated" / f"{name}.png"]
        if kernels.exists():
            command += ["--kernels", kernels]
        done = subprocess.run(command, capture_output=True, text=True,
                              env=os.environ | {"POCL_CACHE_DIR": str(build / "pocl_cache_docs")})
    if done.returncode:
        fail(f"picture {name}: {done.stderr.strip()}")


def hash_of_sources():
    """Of all that a picture can be made of."""
    files = [file.read_bytes() for pattern in ("kernels/**/*.*", "stages/*/kernel.cl", "scenes/**/*", "common/**/*.cpp",
                                               "tests/mutants/*.toml", "stages/*/exercises/*/*.cl", "docs/pictures/*.cl")
             for file in sorted(ROOT.glob(pattern)) if file.is_file()]
    return hashlib.sha256(b"".join(files)).hexdigest()


def draw_pictures(build):
    (PUBLIC / "generated").mkdir(parents=True, exist_ok=True)
    made_of = build / "docs_pictures.json"
    drawn = json.loads(made_of.read_text()) if made_of.exists() else {}
    sources = hash_of_sources()

    def unless_drawn(name, recipe, file, draw_it):
        key = hashlib.sha256((json.dumps(recipe) + sources).encode()).hexdigest()
        if drawn.get(name) != key or not file.exists():
            draw_it()
            drawn[name] = key
            made_of.write_text(json.dumps(drawn, indent=1))

    for name, picture in wanted_pictures().items():
        unless_drawn(name, picture, PUBLIC / "generated" / f"{name}.png", lambda: draw(build, name, picture))
    report = recorded.read("chart.json")
    scenes = [scene["name"] for scene in report["scenes"]]
    unless_drawn("chart", scenes, CHART / "chart.json", lambda: draw_chart(build, scenes))
    show_chart(report)


def draw_chart(build, scenes):
    with tempfile.TemporaryDirectory() as scratch:
        options = [f"--scene={ROOT / 'scenes' / name}.toml" for name in scenes]
        done = subprocess.run([build / "tools" / "chart", "--quick", *options], cwd=scratch, capture_output=True, text=True)
        if done.returncode:
            fail(f"the chart: {done.stderr.strip()}")
        shutil.rmtree(CHART, ignore_errors=True)
        shutil.move(Path(scratch) / "out" / "chart", CHART)


def show_chart(report):
    """The pictures of the quick run, the figures of the recorded one."""
    for scene in report["scenes"]:
        for point in scene["points"]:
            if not (CHART / point["picture"]).exists():  # a quick run takes no samples
                point["picture"] = point["difference"] = None
    (CHART / "chart.json").write_text(json.dumps(report))
    subprocess.run([sys.executable, ROOT / "tests/chart/plot.py", CHART,
                    "/usr/share/javascript/chart.js/chart.min.js"], check=True, stdout=subprocess.DEVNULL)


# --- Copies of sources that pages link to

def copy_sources():
    shutil.rmtree(PUBLIC / "sources", ignore_errors=True)
    for page in [*DOCS.glob("*.md"), *DOCS.glob("chapters/*.md"), *DOCS.glob("stability/*.md")]:
        for link in re.findall(r"\]\(([^)#\s]+)", page.read_text()):
            target = (page.parent / link).resolve()
            if re.match(r"\w+:|/", link) or DOCS in target.parents:
                continue
            if ROOT not in target.parents or not target.is_file():
                fail(f"{page.relative_to(ROOT)}: there is no file {link}")
            copy = PUBLIC / "sources" / f"{target.relative_to(ROOT)}.txt"
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(target, copy)


def write(name, text):
    GENERATED.mkdir(exist_ok=True)
    file = GENERATED / name
    text = "<!-- Made by docs/generate.py: do not edit. -->\n" + text
    if not file.exists() or file.read_text() != text:
        file.write_text(text)


def main():
    build = Path(sys.argv[1]).resolve()
    show_differences()
    show_lessons()
    show_costs()
    show_exercises()
    copy_sources()
    draw_pictures(build)


try:
    main()
except exercises.DoesNotRun as error:
    fail(error)
