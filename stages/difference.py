#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a stage adds to the lesson of the one before.

A stage's lesson is its kernel.cl with all modules that it includes, without what the stage has not
learnt yet (#if), without methods other than the default, and without functions that nothing calls: what
a reader of that stage has to read. stages/budget.toml says how many lines each may add.
"""
import difflib
import functools
import itertools
import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# Of the names that the host defines for a scene, those that a stage is the first to know.
LEARNT = {
    1: {"HAS_SPHERES": 1, "HAS_PLANES": 1},
    2: {"HAS_MATERIALS": 1, "HAS_LIGHTS": 1, "HAS_POINT_LIGHT": 1, "HAS_DIRECTIONAL_LIGHT": 1},
    3: {"HAS_REFLECTION": 1, "MAX_DEPTH": 8, "STACK_SIZE": 9},
    4: {"HAS_DIELECTRIC": 1, "HAS_MEDIA": 1},
    5: {"HAS_TRIANGLES": 1},
    6: {"HAS_TEXTURES": 1, "HAS_MESH_TEXTURES": 1, "HAS_WRAPS": 1, "HAS_CUTOUTS": 1, "HAS_VERTEX_COLORS": 1},
    7: {"PICTURE_IS_IMAGE": 1},
    9: {"HAS_TREE": 1, "HAS_FMA": 1},
    10: {"WIDTH": 16, "PACKETS": 4},
    11: {"HAS_DIELECTRIC_MESH": 1, "HAS_SMOOTH_MESH": 1, "CUTOFF_ONE_IN": 4096},
}
# And those that stand for a count of things which the scene may lack.
COUNTS = {"sphere_count": "HAS_SPHERES", "plane_count": "HAS_PLANES", "light_count": "HAS_LIGHTS",
          "triangle_count": "HAS_TRIANGLES"}
# The lesson of 08 is compiled as C++, OpenCL C and GLSL, and no kernel includes it.
BESIDE = {8: "kernels/transfer_curves.h"}


def stages():
    return sorted(folder for folder in (ROOT / "stages").glob("[0-9][0-9]_*"))


def number_of(stage):
    return int(stage.name[:2])


def included(path, files):
    """Adds the file after all that it includes, each once."""
    if path in files:
        return
    files[path] = lines = []  # where it includes what includes it
    for line in path.read_text().splitlines():
        module = re.match(r'#include "(.*)"', line)
        if not module:
            lines.append(line)
        elif module[1].endswith(".inc"):  # a part of a declaration
            lines += (ROOT / "kernels" / module[1]).read_text().splitlines()[2:]
        else:
            included(ROOT / "kernels" / module[1], files)
    files[path] = files.pop(path)


def value_of(condition, names):
    """Of an #if: names that are not defined count as 0."""
    condition = re.sub(r"defined\((\w+)\)", lambda m: str(int(m[1] in names)), condition)
    while re.search(r"[A-Za-z_]", condition):  # a macro may be defined by others
        condition = re.sub(r"\b[A-Za-z_]\w*", lambda m: str(names.get(m[0], 0)), condition)
    condition = condition.replace("&&", " and ").replace("||", " or ")
    condition = re.sub(r"!(?!=)", " not ", condition)
    return bool(eval(condition, {"__builtins__": {}}))  # our own sources: numbers and operators


def learnt(lines, names):
    """What #if leaves of them to a stage that knows `names`, to which what they define is added."""
    kept = []
    nested = []  # of each #if that is open: whether it is taken, and whether one of its branches was
    for line in lines:
        directive = re.match(r"#\s*(if|ifdef|ifndef|elif|else|endif|define)\b\s*(.*)", line)
        word, rest = directive.groups() if directive else ("", "")
        rest = rest.split("//")[0].strip()
        if word in ("if", "ifdef", "ifndef"):
            value = value_of(rest, names) if word == "if" else (rest in names) == (word == "ifdef")
            nested.append([value, value])
        elif word in ("elif", "else"):
            value = not nested[-1][1] and (word == "else" or value_of(rest, names))
            nested[-1] = [value, value or nested[-1][1]]
        elif word == "endif":
            nested.pop()
        elif all(taken for taken, _ in nested):
            kept.append(line if "HAS_TEXTURES" in names
                        else re.sub(r", (TEXTURES )?textures\b", "", line))
            if word == "define" and (macro := re.match(r"(\w+)\s+(.*)", rest)):
                names.setdefault(*macro.groups())
    return kept


def closing(text, start):
    """The place after the bracket that closes the one at `start`."""
    depth = 0
    for place in range(start, len(text)):
        depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    raise ValueError(f"no end: {text[start:start + 40]}")


def term_value(term, names):
    """Of what stands between two &&: whether it holds, or None where the kernel must ask."""
    term = term.strip()
    if count := re.fullmatch(r"\w+ < scene->(\w+)", term):
        return None if names.get(COUNTS.get(count[1], "")) else False
    if not re.fullmatch(r"!?(HAS_|METHOD_|CUTOFF_)\w+( > 0)?", term):
        return None
    return value_of(term, names)


def resolved(lines, names):
    """What plain if, and loops to a count, leave of them to a stage that knows `names`."""
    text = "\n".join(lines)
    place = 0
    while found := re.compile(r"^ *(if|for) \(", re.MULTILINE).search(text, place):
        end = closing(text, found.end() - 1)
        head = text[found.end():end - 1]
        condition = head.split(";")[1] if found[1] == "for" else head
        terms = [] if "||" in condition else condition.split("&&")
        values = [term_value(term, names) for term in terms]
        body = text.find("{", end)
        place = found.end()
        if body != end + 1 or all(value is None for value in values):
            continue
        after = closing(text, body)
        within, other = text[body + 2:after - 1], ""
        if text[after:].startswith(" else {"):
            begin = after + len(" else ")
            after = closing(text, begin)
            other = text[begin + 2:after - 1]
        rest = [term for term, value in zip(terms, values) if value is None]
        if rest and False not in values:
            kept = condition[:condition.index(condition.strip())] + "&&".join(rest).lstrip()
            text = text[:found.end()] + head.replace(condition, kept) + text[end - 1:]
        else:  # what is done always, or never, stands alone or not at all
            kept = other if False in values else within
            text = text[:found.start()] + re.sub(r"^    ", "", kept.rstrip(" "), flags=re.MULTILINE) + text[after + 1:]
            place = found.start()
    return text.splitlines()


def code_of(line):
    """The line without its comment."""
    return line.split("//")[0].rstrip()


def pieces_of(lines, with_regions=False):
    """Functions, types and macros of a file, each with the comment above it. The marks of regions are left out, or
    outside of others a piece each."""
    piece = []
    depth = 0
    for line in lines:
        if re.match(r"\s*// (#(end)?region|SPDX)", line):
            if not with_regions:
                continue
            if depth == 0:
                yield from ([piece, [line]] if piece else [[line]])
                piece = []
                continue
        piece.append(line)
        code = code_of(line)
        depth += code.count("{") - code.count("}")
        if depth == 0 and (code.endswith((";", "}")) or code_of(piece_start(piece)).startswith("#")
                           and not code.endswith("\\")):
            yield piece
            piece = []


def piece_start(piece):
    """Its first line of code."""
    return next((line for line in piece if code_of(line)), "")


def names_of(piece):
    """What other code calls the piece by; none for what is always kept."""
    text = " ".join(map(code_of, piece)).strip()
    if enumerators := re.match(r"(?:typedef )?enum \w*\s*{(.*)}", text):
        return set(re.findall(r"\w+", enumerators[1]))
    for pattern in (r"#define (\w+)", r"static [^;={]*?\b(\w+)\(", r"__constant \w+ (\w+)",
                    r"typedef .*\b(\w+);$"):
        if found := re.match(pattern, text):
            return {found[1]}
    return set()


def uses_of(piece):
    """All words of the piece."""
    return set(re.findall(r"\w+", " ".join(map(code_of, piece))))


def reached(files, with_regions):
    """Without the pieces that nothing leads to from the kernel."""
    pieces = {file: list(pieces_of(lines, with_regions)) for file, lines in files.items()}
    by_name = {}
    kept = []
    for piece in itertools.chain(*pieces.values()):
        for name in names_of(piece):
            by_name.setdefault(name, []).append(piece)
        if not names_of(piece):
            kept.append(piece)
    wanted = set()
    for piece in kept:  # which grows
        new = uses_of(piece) & by_name.keys() - wanted
        wanted |= new
        for name in new:
            kept += by_name[name]
    return {file: [line for piece in of_file if not names_of(piece) or names_of(piece) & wanted for line in piece]
            for file, of_file in pieces.items()}


def read_members(files):
    """Without members of structs that nothing reads, and what is put into them."""
    text = "\n".join(code_of(line) for lines in files.values() for line in lines)
    ours = "\n".join(code_of(line) for file, lines in files.items() if file.suffix == ".cl"
                     for line in lines)  # those of a .h are the host's too
    structs = re.findall(r"^typedef struct \w+ {\n(.*?)^}", ours, re.MULTILINE | re.DOTALL)
    names = {name for struct in structs
             for name in re.findall(r"[ *](\w+)(?:\[\w+\])*;$", struct, re.MULTILINE)}
    put = r"(?:\w(?:\.|->)%s(?:\[[^]]*\])?(?:\.\w+)? =(?!=)[^;{]*;|[\s{]\.%s = \w+,)"
    unread = {name for name in names
              if not re.search(rf"(?:\.|->){name}\b", re.sub(put % (name, name), "", text))}
    kept = {}
    for file, lines in files.items():
        kept[file] = []
        inside = False  # of a statement that is left out
        for line in lines:
            code = code_of(line)
            name = file.suffix == ".cl" and re.match(r"    [\w ]+[ *](\w+)(?:\[\w+\])*;$", code) \
                or re.match(r"\s*[\w>.\[\]-]*(?:\.|->)(\w+)(?:\[[^]]*\])? =(?!=)", code)
            inside = inside or bool(name and name[1] in unread)
            if not inside:
                kept[file].append(line)
            elif code.endswith(";") or code.lstrip().startswith("."):
                inside = False
    return kept


@functools.cache
def lesson(stage, without=(), with_regions=False):
    """What a reader of the stage reads, or of it in a scene that has no such things: the lines of each file."""
    number = number_of(stage)
    names = {"__OPENCL_VERSION__": 120}
    for first, known in LEARNT.items():
        if first <= number:
            names |= {name: value for name, value in known.items() if name not in without}
    files = {}
    included(stage / "kernel.cl", files)
    files = {file: resolved(learnt(lines, names), names) for file, lines in files.items()}
    before = None
    while files != before:  # what is left out may have been all that asked for something else
        before = files
        files = reached(read_members(files), with_regions)
    for first, file in BESIDE.items():
        if first <= number:
            files[ROOT / file] = (ROOT / file).read_text().splitlines()
    return {str(file.relative_to(ROOT)): lines for file, lines in files.items()
            if any(map(code_of, lines))}


def moved_names(piece):
    """What the piece is called where it may have moved from one file into another."""
    kernel = re.match(r"__kernel void (\w+)\(", piece_start(piece))
    return {kernel[1]} if kernel else names_of(piece)


def compared(before, after):
    """The lessons of both. What stands in another file in the later one is put there in the earlier one: it has been
    read."""
    old, new = lesson(before) if before else {}, lesson(after)
    pieces = {file: list(pieces_of(lines)) for file, lines in old.items()}
    now = {name: file for file, lines in new.items() for piece in pieces_of(lines) for name in moved_names(piece)}
    moved = {file: [] for file in old.keys() | new.keys()}
    for file, of_file in pieces.items():
        for piece in of_file:
            places = {now.get(name, file) for name in moved_names(piece)} or {file}
            moved[file if len(places) > 1 else places.pop()] += piece
    return {file: lines for file, lines in moved.items() if lines}, new


def difference(before, after):
    """Unified, a file at a time."""
    old, new = compared(before, after)
    lines = []
    for file in sorted(old.keys() | new.keys()):
        lines += difflib.unified_diff(old.get(file, []), new.get(file, []), file, file, lineterm="")
    return lines


def counts(lines):
    """Of a difference: how many lines of code it adds, and takes away."""
    code = [line for line in lines if code_of(line[1:]).strip()]
    added = sum(line.startswith("+") and not line.startswith("+++") for line in code)
    removed = sum(line.startswith("-") and not line.startswith("---") for line in code)
    return added, removed


def added_by_file(before, after):
    """Of each file of the later lesson: how many lines of code it has more than in the earlier one."""
    old, new = compared(before, after)
    return {file: counts(list(difflib.unified_diff(old.get(file, []), lines, lineterm="")))[0]
            for file, lines in new.items()}


def introduced(before, after):
    """Of each module of the later lesson that is not as in the earlier one: "new", or "extended"."""
    old = lesson(before) if before else {}
    beside = BESIDE.get(number_of(after))
    return {file.removeprefix("kernels/"): "extended" if file in old else "new"
            for file, lines in added_by_file(before, after).items()
            if file.startswith("kernels/") and file != beside and lines}


def hold_to_signposts():
    """Whether what kernel.cl and the heads of modules say of new and extended modules is so."""
    kept = True
    stages_of = {}  # of a module: those that extend it, the first of which introduces it
    for before, after in itertools.pairwise([None, *stages()]):
        marks = introduced(before, after)
        for module in marks:
            stages_of.setdefault(module, []).append(after.name[:2])
        text = (after / "kernel.cl").read_text()
        said = dict(re.findall(r'^#include "(.*)" *// (new|extended): ', text, re.MULTILINE)) if before else marks
        for module in sorted(said.keys() | marks.keys()):
            if said.get(module) != marks.get(module):
                print(f"{after.name}/kernel.cl: {module} is {marks.get(module, 'as before')}, and it says "
                      f"{said.get(module, 'nothing')}")
                kept = False
    for module, numbers in stages_of.items():
        head = re.match(r"// SPDX.*\n// Introduced by stage ((?:[^:]|\n// )*):", (ROOT / "kernels" / module).read_text())
        said = re.findall(r"\b\d\d\b", head[1]) if head else []
        if said != numbers:
            print(f"kernels/{module}: its head says {', '.join(said) or 'nothing'}; expected Introduced by stage "
                  f"{', '.join(numbers)}")
            kept = False
    return kept


def show(before, after):
    lines = difference(before, after)
    colors = {"+": "\033[32m", "-": "\033[31m", "@": "\033[36m"} if sys.stdout.isatty() else {}
    for line in lines:
        color = colors.get(line[:1], "")
        print(f"{color}{line}\033[0m" if color else line)
    added, removed = counts(lines)
    print(f"{after.name}: {added} lines of code more than {before.name}, {removed} that are gone")


def hold_to_parts(before, after, budget):
    """Of a stage that is taught in parts, each of some modules; whether each part keeps to its budget."""
    left = {file.removeprefix("kernels/").removeprefix(f"stages/{after.name}/"): lines
            for file, lines in added_by_file(before, after).items()}  # in no part so far
    kept = True
    for part, modules in budget["parts"].items():
        lines = sum(left.pop(module, 0) for module in modules)
        print(f"{after.name:24} {lines:4} lines more, of {budget['part_lines']} at the most: {part}")
        if lines > budget["part_lines"]:
            print("  too many: make the part smaller")
            kept = False
    for file, lines in left.items():
        if lines:
            print(f"  {file}: in no part of stages/budget.toml")
            kept = False
    return kept


def hold_to_budget():
    """A table of all steps; whether each keeps to its budget."""
    budget = tomllib.loads((ROOT / "stages" / "budget.toml").read_text())
    usual = budget.pop("lines")
    kept = True
    for before, after in itertools.pairwise(stages()):
        added, removed = counts(difference(before, after))
        of_stage = budget.pop(after.name, None)
        if of_stage and "parts" in of_stage:
            kept = hold_to_parts(before, after, of_stage) and kept
            continue
        lines = of_stage["lines"] if of_stage else usual
        print(f"{after.name:24} {added:4} lines more, of {lines} at the most; {removed} gone")
        if added > lines:
            print("  too many: make the step smaller, or say in stages/budget.toml why it needs them")
        elif of_stage and added <= usual:
            print(f"  it keeps to the usual {usual}: take its own line out of stages/budget.toml")
        else:
            continue
        kept = False
    for name in budget:
        print(f"{name}: stages/budget.toml knows it, and stages/ does not")
    return kept and not budget


def main(arguments):
    by_number = {number_of(stage): stage for stage in stages()}
    if not arguments:
        return 0 if all([hold_to_budget(), hold_to_signposts()]) else 1
    wanted = [by_number.get(int(text[:2])) if text[:2].isdigit() else None for text in arguments]
    if len(wanted) != 2 or None in wanted:
        names = ", ".join(stage.name for stage in by_number.values())
        print(f"diff {' '.join(arguments)}: expected two stages of {names}", file=sys.stderr)
        return 2
    show(*wanted)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
