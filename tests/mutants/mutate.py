# SPDX-License-Identifier: MIT
"""mutate.py ROOT BUILD MUTANTS [NAME…]: runs the tests of BUILD on the kernels of ROOT with one mistake of MUTANTS
(mutants.toml) at a time, all of them or those named, and says which check caught which. Writes out/mutants.json and,
after all of them, ROOT/docs/mutants.md. Exits with 1 where a mistake is caught by no check of its stage."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

DEVICE = "pocl"  # PoCL's: one implementation shows what the checks see
# The programs whose tests can notice what a kernel does: each starts once for a mistake, and runs the cases of the
# mistake's stage. Not what the host does alone, nor what takes longest and sees no more: the goldens' reference,
# each width, doubles, and whole programs.
PROGRAMS = ("golden/golden", "render/render", "kernels/kernels")
WINDOWS = {"07": ("display/presenters",)}  # of a stage whose lesson is in a window
NOT_RUN = ("*DeviceMatchesReference*:*IsTheReferences*:Width.*:*pocl_4_2:*pocl_1_4:*Double.*:"
           "*Bvh.*:*Tree.*:*Limits.*:*Threads.*:*Endurance*:*EveryStage*")
TIMEOUT = 300  # seconds; for a mistake that does not end
KERNEL_FILES = ("kernels/**/*.cl", "kernels/*.inc", "kernels/*.h", "stages/*/kernel.cl", "tests/kernels/*.cl")
DOES_NOT_BUILD = "the kernel does not build"


def fail(text, code=1):
    print(f"stagelight: mutate: {text}", file=sys.stderr)
    sys.exit(code)


def mutated(root, mutant):
    """The text of the mutant's file, with its mistake."""
    where = f"{mutant['name']}: {mutant['file']}, region {mutant['region']}"
    text = (root / mutant["file"]).read_text(encoding="utf-8")
    marks = [f"// #region {mutant['region']}\n", f"// #endregion {mutant['region']}\n"]
    if any(text.count(mark) != 1 for mark in marks):
        fail(f"{where}: there is no such region")
    start, end = (text.index(mark) for mark in marks)
    found = text.count(mutant["find"], start, end)
    if found != 1:
        fail(f"{where}: expected once, found {found} times: {mutant['find']}")
    place = text.index(mutant["find"], start)
    return text[:place] + mutant["replace"] + text[place + len(mutant["find"]):]


class Checks:
    """Runs the checks of BUILD on a copy of the kernels, within a scratch folder."""

    def __init__(self, root, build, scratch):
        self.root, self.build, self.scratch = root, build, scratch
        self.sound = set()
        self.kernels = scratch / "checkout"
        for pattern in KERNEL_FILES:
            for file in root.glob(pattern):
                copy = self.kernels / file.relative_to(root)
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(file, copy)
        # What is built stays for the next mutant: PoCL tells programs apart by their whole text, and a wrong one
        # could at worst hide a mistake.
        cache = scratch / "pocl"
        cache.mkdir()
        self.environment = os.environ | {"STAGELIGHT_DEVICE": DEVICE, "STAGELIGHT_KERNELS": str(self.kernels),
                                         "POCL_CACHE_DIR": str(cache)}

    def files(self, program):
        """What it says, and what it finds."""
        name = self.scratch / program.split("/")[1]
        return name.with_suffix(".txt"), name.with_suffix(".json")

    def start(self, program, cases):
        said, results = self.files(program)
        results.unlink(missing_ok=True)
        with open(said, "w", encoding="utf-8") as output:
            return subprocess.Popen(
                [self.build / "tests" / f"{program}_tests", f"--gtest_filter={cases}:-{NOT_RUN}",
                 f"--gtest_output=json:{results}"],
                cwd=self.scratch, env=self.environment, stdout=output, stderr=subprocess.STDOUT)

    def failures(self, program, process):
        try:
            process.wait(TIMEOUT)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        said, results = self.files(program)
        said = said.read_text(encoding="utf-8", errors="replace")
        if not results.exists():  # it crashed, or did not end
            started = re.findall(r"\[ RUN      \] (\S+)", said)
            return started[-1:] or fail(f"{program}_tests runs no test:\n{said}"), said
        suites = json.loads(results.read_text(encoding="utf-8"))["testsuites"]
        return [f"{suite['name']}.{case['name']}" for suite in suites for case in suite["testsuite"]
                if "failures" in case], said

    def run(self, stage, what):
        """The stage's, or all where it is None, on `what` is planted: the names of those that fail."""
        cases = "*" if stage is None else f"*Stage{stage}*"
        started = [(program, self.start(program, cases)) for program in PROGRAMS + WINDOWS.get(stage, ())]
        failed = []
        for program, process in started:
            names, said = self.failures(program, process)
            if DOES_NOT_BUILD in said:
                fail(f"{what}: {DOES_NOT_BUILD}: {re.search('.*error: .*', said)[0]}")
            failed += names
        return failed

    def require_sound(self, stage):
        """Once for each stage: what fails without a mistake says nothing of one."""
        if stage not in self.sound:
            failed = self.run(stage, "no mistake")
            if failed:
                fail(f"without a mistake, {len(failed)} checks fail: {', '.join(failed)}")
            self.sound.add(stage)

    def catch(self, mutant):
        """The stage's checks that catch the mistake; where none does, others that do."""
        file = self.kernels / mutant["file"]
        right = file.read_text(encoding="utf-8")
        self.require_sound(mutant["stage"])
        wrong = mutated(self.root, mutant)
        file.write_text(wrong, encoding="utf-8")
        caught = self.run(mutant["stage"], mutant["name"])
        elsewhere = []
        if not caught:
            file.write_text(right, encoding="utf-8")
            self.require_sound(None)
            file.write_text(wrong, encoding="utf-8")
            elsewhere = self.run(None, mutant["name"])
        file.write_text(right, encoding="utf-8")
        return caught, elsewhere


def verdict(result):
    if result["caught"]:
        return f"caught by {len(result['caught'])}: {result['caught'][0]}"
    if result["elsewhere"]:
        return f"MISSED by its stage, caught by {result['elsewhere'][0]}"
    return "SURVIVES"


def page(results):
    caught = sum(bool(result["caught"]) for result in results)
    lines = ["<!-- Written by ./stagelight mutate: do not edit. -->", "# Known mistakes, and which check catches them",
             "", f"{caught} of {len(results)}. `./stagelight mutate` builds the kernels with one mistake at a time "
             "(`tests/mutants/mutants.toml`), runs the checks of the stage that teaches what is wrong, on PoCL, and "
             "fails where none of them does.", "",
             "| mistake | what is wrong | stage | caught by |", "|---|---|---|---|"]
    for result in results:
        checks = "<br>".join(f"`{check}`" for check in result["caught"])
        lines.append(f"| `{result['name']}` | {result['mistake']} | {result['stage']} | {checks} |")
    return "\n".join(lines) + "\n"


def main():
    root, build, file = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
    names = sys.argv[4:]
    with open(file, "rb") as stream:
        mutants = tomllib.load(stream)["mutants"]
    known = [mutant["name"] for mutant in mutants]
    for name in names:
        if name not in known:
            fail(f"no mistake '{name}'; there are: {', '.join(known)}", 2)
    for mutant in mutants:  # before anything is run
        mutated(root, mutant)
    chosen = [mutant for mutant in mutants if not names or mutant["name"] in names]
    results = []
    out = pathlib.Path("out")
    out.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        checks = Checks(root, build, pathlib.Path(scratch))
        for mutant in chosen:
            caught, elsewhere = checks.catch(mutant)
            caught = [re.sub(f"(_on_|[/_]){DEVICE}(_16_8)?(?=_|$)", "", check) for check in caught]
            results.append(mutant | {"caught": caught, "elsewhere": elsewhere})
            print(f"{mutant['stage']}  {mutant['name']:32} {verdict(results[-1])}", flush=True)
            (out / "mutants.json").write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    missed = [result["name"] for result in results if not result["caught"]]
    print(f"{len(results) - len(missed)} of {len(results)} mistakes caught by their stage")
    if not names and not missed:
        (root / "docs" / "mutants.md").write_text(page(results), encoding="utf-8")
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
