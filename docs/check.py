# SPDX-License-Identifier: MIT
"""check.py pages | site FOLDER: what would let the course drift from its code, told by file and line; exits with 1.

pages: listings name regions that are there, words in code font name something in the sources, chapters have their
parts, pictures are drawn and shown. site: no page of the built site has a dead link or asks an outside address."""
import html.parser
import os
import re
import sys
import tomllib
import urllib.parse
from pathlib import Path

import recorded

sys.path.append(str(Path(__file__).resolve().parent.parent / "stages"))
import difference  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
HEADINGS = ["The question", "The idea", "The mathematics", "The code", "What changed", "The picture", "What it costs",
            "What goes wrong", "Exercises", "Further reading"]
WORDS = 1200, 2500  # of prose in a chapter
EXERCISES, EXERCISES_OF_STAGE = 30, 3
# Other people's names, which no source of ours has.
FOREIGN = set((DOCS / "foreign_words.txt").read_text().split())
PATH = re.compile(r"[\w./*-]*[\w*]\.(?:cl|cpp|h|toml|py|sh|md|txt|exr|obj|cmake|mts|vue)\b")

problems = []


def wrong(file, line, what):
    problems.append(f"{file.relative_to(ROOT)}:{line}: {what}")


def sources():
    """All files but those that .gitignore names. Not by git: who downloads an archive needs none."""
    made = {ROOT / line.strip("/") for line in (ROOT / ".gitignore").read_text().split()} | {ROOT / ".git"}
    for folder, folders, names in os.walk(ROOT):
        folders[:] = [name for name in folders if Path(folder, name) not in made and name != "__pycache__"]
        yield from (Path(folder, name) for name in names)


def known_words(files):
    """All words of the sources, and the parts of their names. Not of the pages that are checked."""
    words = set(FOREIGN)
    for file in files:
        relative = file.relative_to(ROOT)
        words.update(re.findall(r"\w+", str(relative)))
        if file.suffix in (".exr", ".png", ".md", ".svg") or relative.parts[:2] == ("docs", "recorded"):
            continue
        words.update(re.findall(r"\w+", file.read_text(errors="replace")))
    return words


def prose_of(page):
    """Its lines with their numbers, without listings, mathematics and what is included."""
    fence = None
    for number, line in enumerate(page.read_text().splitlines(), 1):
        if mark := re.match(r"\s*(`{3,}|\$\$)", line):
            if fence is None:
                fence = mark[1] if not line.strip()[2:].endswith("$$") else None
            elif line.strip().startswith(fence) or line.strip().endswith(fence):
                fence = None
            continue
        if fence == "$$" and line.strip().endswith("$$"):
            fence = None
            continue
        if fence is None and not re.match(r"<<<|<!--|---|title:", line):
            yield number, line


def check_code_font(page, known, paths):
    for number, line in prose_of(page):
        for span in re.findall(r"(?<!`)`([^`]+)`(?!`)", line):
            for path in re.findall(PATH, span):
                name = path.removeprefix("./").replace("../", "")
                if name.startswith(("out/", "build/", "work/", "/")) or "*" in name or "NN" in name:
                    continue
                if not any(known_path.endswith("/" + name) for known_path in paths):
                    wrong(page, number, f"there is no file {path}")
            for word in re.findall(r"\b[A-Za-z_]\w+", span):
                if word not in known and word != "NN_name":
                    wrong(page, number, f"nothing in the sources is called {word}")


def check_listings(page):
    stage = ROOT / "stages" / page.stem
    shown = difference.lesson(stage, with_regions=True) if stage.is_dir() else {}  # docs/generate.py, show_lessons
    for number, line in enumerate(page.read_text().splitlines(), 1):
        if listing := re.match(r"<<< (\S+?)(?:#(\w+))?\{", line):
            file, region = (page.parent / listing[1]).resolve(), listing[2]
            if not file.is_file():
                wrong(page, number, f"there is no file {listing[1]}")
                continue
            text = "\n".join(shown.get(str(file.relative_to(ROOT)), [])) or file.read_text()
            if region and any(len(re.findall(rf"#{mark} {region}$", text, re.MULTILINE)) != 1
                              for mark in ("region", "endregion")):
                wrong(page, number, f"{listing[1]} has no region {region}, or more than one")
        elif line.startswith("<<<"):
            wrong(page, number, "expected <<< FILE#REGION{LANGUAGE}")
        if (part := re.match(r"<!--@include: (\S+)-->", line)) and not (page.parent / part[1]).is_file():
            wrong(page, number, f"there is nothing to include as {part[1]}")


def check_chapter(page):
    text = page.read_text()
    found = re.findall(r"^## (.+)$", text, re.MULTILINE)
    if found != HEADINGS:
        wrong(page, 1, f"expected the headings {', '.join(HEADINGS)}; found {', '.join(found)}")
    low, high = WORDS
    count = sum(len(re.findall(r"[\w'’-]*[A-Za-z][\w'’-]*", re.sub(r"<[^>]*>|\$[^$]*\$|\]\([^)]*\)", " ", line)))
                for _, line in prose_of(page))
    if not low <= count <= high:
        wrong(page, 1, f"{count} words: expected {low} to {high}")
    exercises = list((ROOT / "stages" / page.stem / "exercises").glob("[0-9]*_*"))
    if len(exercises) < EXERCISES_OF_STAGE:
        wrong(page, 1, f"{len(exercises)} exercises: expected {EXERCISES_OF_STAGE} or more")
    for what in ('<svg', '<Compare '):
        if what not in text + "".join((page.parent / f).resolve().read_text()
                                      for f in re.findall(r"@include: (\S+\.svg)", text)
                                      if (page.parent / f).resolve().is_file()):
            wrong(page, 1, f"expected a {what.strip('< ')} in it")


def check_drawing(drawing):
    text = drawing.read_text()
    if "\n\n" in text.strip() or not text.startswith("<svg ") or "<style" in text:
        wrong(drawing, 1, "expected <svg first, no empty line and no style: it is put into pages as it is")
    for needed in ('role="img"', "<title id=", 'aria-labelledby="', "viewBox="):
        if needed not in text:
            wrong(drawing, 1, f"expected {needed} in it")


def check_pictures(pages):
    wanted = {}
    for file in sorted((DOCS / "pictures").glob("*.toml")):
        for name in tomllib.loads(file.read_text()):
            wanted[name] = file
    shown = set()
    for page in pages:
        for number, line in enumerate(page.read_text().splitlines(), 1):
            for name in re.findall(r'<(?:Picture name|Compare before)="(\w+)"|after="(\w+)"|generated/(\w+)\.png', line):
                name = "".join(name)
                shown.add(name)
                if name not in wanted:
                    wrong(page, number, f"no docs/pictures/*.toml says how to draw {name}")
    for name in wanted.keys() - shown:
        wrong(wanted[name], 1, f"no page shows {name}")


def check_readme():
    """Its table has the medians of the recorded run, to two digits."""
    runs = [scene["own"] for scene in recorded.read("costs.json")["scenes"].values()]
    medians = {run["stage"]: run["median"] for run in runs}
    for number, line in enumerate((ROOT / "README.md").read_text().splitlines(), 1):
        if row := re.match(r"\| \[(\d\d_\w+)\]\(.*\| ([\d.]+) \|$", line):
            expected = f"{float(f'{medians.pop(row[1], 0):.2g}'):g}"
            if row[2] != expected:
                wrong(ROOT / "README.md", number, f"{row[2]} ms, recorded {expected}")
    if medians:
        problems.append(f"README.md: no row for {', '.join(medians)}")


def check_pages():
    files = sorted(sources())
    known = known_words(files)
    paths = ["/" + str(file.relative_to(ROOT)) for file in files]
    chapters = sorted((DOCS / "chapters").glob("*.md"))
    pages = sorted(DOCS.glob("*.md")) + chapters + [DOCS / "stability" / "index.md"]
    tasks = sorted(ROOT.glob("stages/*/exercises/*/README.md"))
    for page in pages + tasks + sorted(ROOT.glob("stages/*/core/*/README.md")):
        if page.read_text().startswith("<!-- Written by"):
            continue  # by one of our programs
        check_code_font(page, known, paths)
        check_listings(page)
    for chapter in chapters:
        check_chapter(chapter)
    stages = {folder.name for folder in (ROOT / "stages").glob("[0-9][0-9]_*")}
    for stage in sorted(stages - {chapter.stem for chapter in chapters}):
        problems.append(f"docs/chapters: {stage} has no chapter")
    if len(tasks) < EXERCISES:
        problems.append(f"stages: {len(tasks)} exercises, expected {EXERCISES} or more")
    for drawing in sorted((DOCS / "drawings").glob("*.svg")):
        check_drawing(drawing)
    check_pictures(pages)
    check_readme()


# --- The built site

class Page(html.parser.HTMLParser):
    """What a page leads to and what can be led to in it."""

    def __init__(self, text):
        super().__init__()
        self.ids, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if "id" in attributes:
            self.ids.add(attributes["id"])
        self.links += [attributes[name] for name in ("href", "src") if attributes.get(name)]


def check_site(folder):
    pages = {file: Page(file.read_text()) for file in folder.rglob("*.html")}
    for file, page in pages.items():
        for link in page.links:
            address = urllib.parse.urlsplit(link)
            if address.scheme == "data":
                continue
            if address.scheme or address.netloc:
                problems.append(f"{file.relative_to(folder)}: leads out of the site: {link}")
                continue
            path = urllib.parse.unquote(address.path)
            target = file if not path else folder / path.lstrip("/") if path.startswith("/") else file.parent / path
            target = target.resolve()
            target = next((t for t in (target, target.with_name(target.name + ".html"), target / "index.html")
                           if t.is_file()), None)
            if target is None:
                problems.append(f"{file.relative_to(folder)}: dead link {link}")
            elif address.fragment and target in pages and \
                    urllib.parse.unquote(address.fragment) not in pages[target].ids:
                problems.append(f"{file.relative_to(folder)}: {link}: the page has no such place")
    if not pages:
        problems.append(f"{folder} has no page")


def main():
    if sys.argv[1] == "pages":
        check_pages()
    else:
        check_site(Path(sys.argv[2]).resolve())
    for problem in problems:
        print(problem, file=sys.stderr)
    sys.exit(1 if problems else 0)


main()
