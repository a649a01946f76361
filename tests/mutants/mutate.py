# SPDX-License-Identifier: MIT
"""mutate.py ROOT BUILD MUTANTS [NAME…]: runs the tests of BUILD on the kernels of ROOT with one mistake of MUTANTS
(mutants.toml) at a time, all of them or those named, and says which check caught which. Writes out/mutants.json and,
after all of them, ROOT/docs/mutants.md. Exits with 1 where a mistake is caught by no check of its stage.

mutate.py ROOT BUILD MUTANTS --random N --seed S [kernels] [host] [reference]: the same of N mistakes drawn at random that change
something (draw.py). Exits with 1 where one survives."""
import argparse
import collections
import hashlib
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import tomllib

import draw

DEVICE = "pocl"  # PoCL's: one implementation shows what the checks see
# The programs whose tests can notice what a kernel does: each starts once for a mistake, and runs the cases of the
# mistake's stage. Not what the host does alone, nor what takes longest and sees no more: the goldens' reference,
# each width, doubles, and whole programs.
PROGRAMS = ("golden/golden", "render/render", "kernels/kernels")
WINDOWS = {"07": ("display/presenters",)}  # of a stage whose lesson is in a window
NOT_RUN = ("*DeviceMatchesReference*:*IsTheReferences*:Width.*:*pocl_4_2:*pocl_1_4:*Double.*:"
           "*Bvh.*:*Tree.*:*Limits.*:*Threads.*:*Endurance*:*EveryStage*")
TIMEOUT = 300  # seconds of a processor; for a mistake that does not end
KERNEL_FILES = ("kernels/**/*.cl", "kernels/*.inc", "kernels/*.h", "stages/*/kernel.cl", "tests/kernels/*.cl")
DOES_NOT_BUILD = "the kernel does not build"
MOST_MEMORY = 16 << 30  # bytes, of a process
# Asked before a mistake is said to survive: minutes each.
LAST_RESORTS = r"^(oclgrind|stability|chart|precision)"


def ctest(build, arguments, environment=None):
    """The first tests that fail."""
    done = subprocess.run(["ctest", "--test-dir", build, "--stop-on-failure", "--parallel", str(os.cpu_count()), "--timeout",
                           str(4 * TIMEOUT), *arguments], env=environment, capture_output=True, text=True)
    failed = dict(re.findall(r"^\t\s*\d+ - (\S+) \((.*)\)$", done.stdout, re.M))
    if "Not Run" in failed.values():
        fail(f"{build}: not all tests are built: {', '.join(failed)}")
    return list(failed)


def fail(text, code=1):
    print(f"stagelight: mutate: {text}", file=sys.stderr)
    sys.exit(code)


class DoesNotBuild(Exception):
    """The compiler's first error."""


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


def end(started):
    for _, process in started:
        process.kill()
        process.wait()


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

    def start(self, program, cases, *options):
        said, results = self.files(program)
        results.unlink(missing_ok=True)
        with open(said, "w", encoding="utf-8") as output:
            return subprocess.Popen(
                [self.build / "tests" / f"{program}_tests", f"--gtest_filter={cases}:-{NOT_RUN}",
                 f"--gtest_output=json:{results}", *options],
                cwd=self.scratch, env=self.environment, stdout=output, stderr=subprocess.STDOUT,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (TIMEOUT, TIMEOUT)))

    def failures(self, program, process):
        process.wait()
        said, results = self.files(program)
        said = said.read_text(encoding="utf-8", errors="replace")
        if DOES_NOT_BUILD in said:
            raise DoesNotBuild((re.search(".*error: .*", said) or [said])[0])
        if not results.exists():  # it crashed, or did not end
            started = re.findall(r"\[ RUN      \] (\S+)", said)
            return started[-1:] or fail(f"{program}_tests runs no test:\n{said}")
        suites = json.loads(results.read_text(encoding="utf-8"))["testsuites"]
        return [f"{suite['name']}.{case['name']}" for suite in suites for case in suite["testsuite"]
                if "failures" in case]

    def run(self, stage):
        """The stage's, or all where it is None: the names of those that fail. Raises DoesNotBuild."""
        cases = "*" if stage is None else f"*Stage{stage}*"
        started = [(program, self.start(program, cases)) for program in PROGRAMS + WINDOWS.get(stage, ())]
        try:
            return [name for program, process in started for name in self.failures(program, process)]
        finally:
            end(started)

    def last_resorts(self, labels=LAST_RESORTS):
        return ctest(self.build, ["-L", labels], self.environment)

    def require_sound(self, stage, run=None):
        """Once for each stage: what fails without a mistake says nothing of one."""
        if stage not in self.sound:
            failed = run() if run else self.run(stage)
            if failed:
                fail(f"without a mistake, {len(failed)} checks fail: {', '.join(failed)}")
            self.sound.add(stage)

    def catch(self, mutant):
        """The stage's checks that catch the mistake; where none does, others that do."""
        file = self.kernels / mutant["file"]
        right = file.read_text(encoding="utf-8")
        wrong = mutated(self.root, mutant)
        caught = elsewhere = []
        for stage, run in ((mutant["stage"], None), (None, None), ("last resorts", self.last_resorts)):
            self.require_sound(stage, run)
            file.write_text(wrong, encoding="utf-8")
            try:
                elsewhere = run() if run else self.run(stage)
            except DoesNotBuild as error:
                fail(f"{mutant['name']}: {DOES_NOT_BUILD}: {error}")
            finally:
                file.write_text(right, encoding="utf-8")
            if stage == mutant["stage"]:
                caught, elsewhere = elsewhere, []
            if caught or elsewhere:
                break
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


def known_mistakes(root, build, file, names):
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


# --- Drawn at random

class InKernels(Checks):
    """Of a mistake in a kernel: the tests of the stage that its file says first, then all."""

    def first_failure(self, cases):
        for program in ("kernels/kernels", "golden/golden", "render/render"):  # the quickest first
            process = self.start(program, cases, "--gtest_fail_fast")
            if process.wait():
                return self.failures(program, process)
        return []

    def outcome(self, mistake):
        file = self.kernels / mistake.file
        right = file.read_text(encoding="utf-8")
        stage = re.search(r"stage (\d\d)", right)
        file.write_text(mistake.planted(right), encoding="utf-8")
        try:
            killed = stage and self.first_failure(f"*Stage{stage[1]}*") or self.first_failure("*") \
                or self.last_resorts(f"{LAST_RESORTS}|^(kernels|render|golden|display)")
        except DoesNotBuild:
            return "does not build", None
        finally:
            file.write_text(right, encoding="utf-8")
        if not killed:
            return "SURVIVES", None
        name = killed[0]  # of a test of the programs, or of ctest's
        self.require_sound(name, lambda: self.first_failure(name)
                           or ctest(self.build, ["-R", f"^{re.escape(name)}$"], self.environment))
        return "killed", name


# By folder: the programs of tests/ whose tests are built and run first. All others follow.
FIRST_TESTS = {"common/scene": ("scene",), "common/device": ("golden",), "common/display": ("display", "rungs"),
               "common/image": ("image",), "common/app": ("cli",), "common/budget": ("budget",), "common/pov": ("pov",),
               "common/reference": ("golden", "reference"), "layer": ("layer", "layer_alone", "layer_without_gl_event")}


class InPrograms:
    """Of a mistake in what the host's compiler builds: in a copy of ROOT with a build of its own."""

    def __init__(self, root, build):
        self.build = build
        self.copy = root / "build" / "mutants"
        files = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True, check=True).stdout.splitlines()
        for name in files:
            file, copy = root / name, self.copy / name
            if file.is_file() and not (copy.is_file() and copy.read_bytes() == file.read_bytes()):
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, copy)
        subprocess.run(["cmake", "--preset", "release", "-D", "BUILD_TESTING=ON"], cwd=self.copy, check=True, capture_output=True)
        self.own = self.copy / "build" / "release"
        if not self.make():
            fail(f"without a mistake, it does not build:\n{self.said}")
        self.objects = self.hashes()
        self.unsound = set()
        self.environment = os.environ | {"POCL_CACHE_DIR": str(self.copy / "build" / "pocl")}
        (self.copy / "build" / "pocl").mkdir(exist_ok=True)

    def make(self, *targets):
        done = subprocess.run(["ninja", f"-j{os.cpu_count()}", "-C", self.own, *targets], capture_output=True, text=True)
        self.said = done.stdout
        return done.returncode == 0

    def hashes(self):
        return {file: hashlib.sha256(file.read_bytes()).digest() for file in self.own.rglob("*.o")}

    def fails_without(self, test):
        """A test that fails in BUILD as well says nothing."""
        if test not in self.unsound and ctest(self.build, ["-R", f"^{re.escape(test)}$"]):
            self.unsound.add(test)
        return test in self.unsound

    def killers(self, *arguments):
        while True:
            left_out = ["-E", f"^({'|'.join(map(re.escape, self.unsound))})$"] if self.unsound else []
            failed = ctest(self.own, [*arguments, *left_out], self.environment)
            if not any([self.fails_without(test) for test in failed]):
                return failed

    def outcome(self, mistake):
        file = self.copy / mistake.file
        right = file.read_text(encoding="utf-8")
        file.write_text(mistake.planted(right), encoding="utf-8")
        first = next(programs for folder, programs in FIRST_TESTS.items() if mistake.file.startswith(folder))
        try:
            for program in first:
                if not self.make(f"{program}_tests"):
                    return "does not build", None
                if killed := self.hashes() != self.objects and self.killers("-L", f"^{program}(\\.|$)"):
                    return "killed", killed[0]
            if not self.make():
                return "does not build", None
            if self.hashes() == self.objects:
                return "changes nothing", None
            killed = self.killers("-LE", f"^({'|'.join(first)})(\\.|$)")
        finally:
            file.write_text(right, encoding="utf-8")
        return ("killed", killed[0]) if killed else ("SURVIVES", None)


def random_mistakes(root, build, count, seed, kinds):
    """Writes out/random_mistakes.json as it goes. The number of those that survive."""
    shares = {kind: share for kind, (share, _) in draw.KINDS.items() if kind in kinds}
    results = []
    out = pathlib.Path("out")
    out.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        for kind, share in shares.items():
            checks = InKernels(root, build, pathlib.Path(scratch)) if kind == "kernels" else InPrograms(root, build)
            wanted = -(-count * share // sum(shares.values()))
            for mistake in draw.draw(root, kind, seed):
                found, by = checks.outcome(mistake)
                told = mistake.told((root / mistake.file).read_text(encoding="utf-8"))
                results.append({"kind": kind, "mistake": told, "found": found, "by": by})
                print(f"{kind}  {told}: {found}{' by ' + by if by else ''}", flush=True)
                (out / "random_mistakes.json").write_text(json.dumps({"seed": seed, "results": results}, indent=1) + "\n",
                                                          encoding="utf-8")
                wanted -= found in ("killed", "SURVIVES")
                if wanted <= 0:
                    break
    survive = 0
    for kind in shares:
        each = collections.Counter(result["found"] for result in results if result["kind"] == kind)
        changing = each["killed"] + each["SURVIVES"]
        survive += each["SURVIVES"]
        print(f"{kind}: {each['killed']} of {changing} killed ({each['killed'] / max(1, changing):.0%}), besides "
              f"{each['does not build']} that do not build and {each['changes nothing']} that change nothing")
    return survive


def main():
    root, build = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    parser = argparse.ArgumentParser(prog="stagelight mutate", add_help=False)
    parser.add_argument("--random", type=int)
    parser.add_argument("--seed", type=int)
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args(sys.argv[4:])
    if arguments.random is None:
        known_mistakes(root, build, pathlib.Path(sys.argv[3]).resolve(), arguments.names)
    if arguments.seed is None or arguments.random < 1:
        fail("--random N --seed S: expected two whole numbers, N above 0", 2)
    for name in arguments.names:
        if name not in draw.KINDS:
            fail(f"--random {name}: expected {', '.join(draw.KINDS)}", 2)
    # A mistake may ask for memory without end.
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    for name in ("STAGELIGHT_DEVICE", "STAGELIGHT_KERNELS", "STAGELIGHT_RESULTS"):
        os.environ.pop(name, None)
    sys.exit(1 if random_mistakes(root, build, arguments.random, arguments.seed, arguments.names or list(draw.KINDS)) else 0)


if __name__ == "__main__":
    main()
