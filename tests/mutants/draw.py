# SPDX-License-Identifier: MIT
"""Mistakes drawn at random for ./stagelight mutate --random: line, operator and place. What a line is, and which operators there
are, decides the draw together with the seed, so that a recorded seed draws the same mistakes of the same sources."""
import random
import re
from dataclasses import dataclass

# Three kernels' mistakes and two of the host and layer to one of the reference.
KINDS = {
    "kernels": (3, ("kernels/**/*.cl",)),
    "host": (2, ("common/**/*.cpp", "common/**/*.h", "layer/*.cpp", "layer/*.h")),
    "reference": (1, ("common/reference/*.h", "common/reference/*.cpp")),
}

EXCHANGED = {
    "relation": ((" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" < ", " > "), (" > ", " < "),
                 (" == ", " != "), (" != ", " == ")),
    "arithmetic": ((" + ", " - "), (" - ", " + "), (" * ", " / "), (" / ", " * "), (" % ", " / "), (" += ", " -= "),
                   (" -= ", " += "), (" *= ", " /= "), ("++", "--"), ("--", "++"), (" << ", " >> "), (" >> ", " << ")),
    "logic": ((" && ", " || "), (" || ", " && "), (" & ", " | "), (" | ", " & "), (" |= ", " &= "), (" &= ", " |= ")),
    "function": (("min(", "max("), ("max(", "min("), ("MIN(", "MAX("), ("MAX(", "MIN("), ("floor(", "ceil("), ("ceil(", "floor("),
                 ("sin(", "cos("), ("cos(", "sin("), ("any_of(", "all_of("), ("all_of(", "any_of("), ("fabs(", "("), ("abs(", "("),
                 ("sqrt(", "(")),
    "component": ((".x", ".y"), (".y", ".z"), (".z", ".x"), (".lo", ".hi"), (".hi", ".lo")),
    "truth": (("true", "false"), ("false", "true"), ("break;", "continue;"), ("continue;", "break;")),
}
NUMBER = re.compile(r"(?<![\w.])(\d+\.\d*(?:[eE][-+]?\d+)?|\d+(?:[eE][-+]?\d+)?)([fFuULl]*)(?![\w.])")
SIGN = re.compile(r"(?:(?<=[,=?:] )|(?<=return )|(?<=\())-(?=[\w(.])")
NOT = re.compile(r"!(?=[\w(])")
CONDITION = re.compile(r"\b(?:if|while) \((.+)\) \{$")
# A statement that ends where it begins, and declares nothing.
STATEMENT = re.compile(r"^\s+(?:[\w.>\[\]*()-]+ [-+*/|&]?= [^{}]*;|[\w.:>-]+\(.*\);|(?:\+\+|--)[\w.>-]+;|[\w.>-]+(?:\+\+|--);)$")
NO_CODE = re.compile(r"^\s*(?:$|#include|#pragma|#line|namespace|using|static_assert|extern|typedef|template)")


@dataclass(frozen=True)
class Mistake:
    kind: str
    file: str
    line: int  # from 1
    start: int
    end: int
    new: str

    def planted(self, text):
        lines = text.split("\n")
        line = lines[self.line - 1]
        lines[self.line - 1] = line[:self.start] + self.new + line[self.end:]
        return "\n".join(lines)

    def told(self, text):
        """As a line of a report: where, and the line with and without it."""
        old, new = (each.split("\n")[self.line - 1].strip() for each in (text, self.planted(text)))
        return f"{self.file}:{self.line}: {old}  ->  {new or '(nothing)'}"


def bare(line):
    """The line without its comment, and with nothing to find in its strings."""
    line = re.sub(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'', lambda text: "\0" * len(text[0]), line)
    return line.split("//")[0].rstrip()


def other_numbers(digits, suffix):
    value = float(digits) if re.search(r"[.eE]", digits) else int(digits)
    if isinstance(value, int):
        return [f"{other}{suffix}" for other in (value + 1, value - 1) if other >= 0]
    return [f"{other!r}{suffix}" for other in ((1.0,) if value == 0 else (2 * value, 0.0, value / 2))]


def mistakes_in(line, before):
    """By operator, the places of a line, each with what may stand there. `before`: the line of code before it."""
    code = bare(line)
    found = {}

    def add(operator, start, end, new):
        found.setdefault(operator, []).append((start, end, new))

    if NO_CODE.match(code) or not code:
        return found
    for operator, pairs in EXCHANGED.items():
        for old, new in pairs:
            for place in re.finditer(re.escape(old) if old[0] in ". +-" or old[-1] == " " else r"\b" + re.escape(old), code):
                if old[0] != "." or not re.match(r"\w", code[place.end():]):
                    add(operator, place.start(), place.end(), new)
    for place in NUMBER.finditer(code):
        for new in other_numbers(place[1], place[2]):
            add("constant", place.start(), place.end(), new)
    for place in SIGN.finditer(code):
        add("sign", place.start(), place.end(), "")
    for place in NOT.finditer(code):
        add("logic", place.start(), place.end(), "")
    if place := CONDITION.search(code):
        add("condition", place.start(1), place.end(1), f"!({line[place.start(1):place.end(1)]})")
    if STATEMENT.match(code) and before.endswith((";", "{", "}", ":")):
        add("statement", 0, len(line), "")
    return found


def lines_of(root, kind):
    """Of each line that a mistake can be made in: its file, its number and the mistakes."""
    lines = []
    for file in sorted({file for pattern in KINDS[kind][1] for file in root.glob(pattern)}):
        name = str(file.relative_to(root))
        if kind == "host" and name.startswith("common/reference/"):
            continue
        before = ";"
        for number, line in enumerate(file.read_text(encoding="utf-8").split("\n"), 1):
            if found := mistakes_in(line, before):
                lines.append((name, number, found))
            before = bare(line) or before
    return lines


def draw(root, kind, seed):
    """Without end, each once."""
    dice = random.Random(f"{seed} {kind}")
    lines = lines_of(root, kind)
    drawn = set()
    while True:
        file, number, found = dice.choice(lines)
        places = found[dice.choice(sorted(found))]
        mistake = Mistake(kind, file, number, *dice.choice(places))
        if mistake not in drawn:
            drawn.add(mistake)
            yield mistake
