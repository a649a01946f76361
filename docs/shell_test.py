# SPDX-License-Identifier: MIT
"""shell_test.py BUILD: runs every command that the course shows in an sh block, in the order of the pages, from the
checkout's folder; each once. What stands in a reader's build/release is taken from BUILD."""
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LIMIT = 300  # seconds
# What would take too long, or is run elsewhere: not run, but what it asks for must be there.
NOT_HERE = {
    "./stagelight test": "CI runs it",
    "./stagelight docs": "it is what brought us here",
    "./stagelight docs serve": "it does not end",
    "./stagelight mutate --random 120 --seed 1": "it takes hours",
}


def commands():
    """With where they stand."""
    pages = sorted((ROOT / "docs").glob("*.md")) + sorted((ROOT / "docs/chapters").glob("*.md"))
    for page in pages:
        block = False
        for number, line in enumerate(page.read_text().splitlines(), 1):
            if re.match(r"```", line):
                block = line.startswith("```sh") and not block
            elif block and (command := line.split(" # ")[0].strip()) and not line.startswith("#"):
                yield f"{page.relative_to(ROOT)}:{number}", command


def main():
    passed, failed, seen = 0, 0, set()
    for where, command in commands():
        if command in seen or command in NOT_HERE:
            continue
        seen.add(command)
        start = time.monotonic()
        here = command.replace("build/release/", f"{sys.argv[1]}/")
        try:
            done = subprocess.run(["bash", "-c", here], cwd=ROOT, stdin=subprocess.DEVNULL, timeout=LIMIT,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
            code, output = done.returncode, done.stdout
        except subprocess.TimeoutExpired:
            code, output = "none", f"not done in {LIMIT} s"
        passed, failed = passed + (code == 0), failed + (code != 0)
        print(f"{where}: {command}: {'runs' if code == 0 else 'FAILS'}, {time.monotonic() - start:.1f} s", flush=True)
        if code != 0:
            print(output[-2000:], f"exit code {code}", sep="\n", file=sys.stderr)
    print(f"commands: {passed} passed, {failed} failed")
    sys.exit(1 if failed or not passed else 0)


main()
