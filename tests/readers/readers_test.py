# SPDX-License-Identifier: MIT
"""readers_test.py TRACER WHAT: `meshes` and `pictures` draw a few of each; `judge` and `picture_judge` plant mistakes that
must be seen; `page` looks for each file in docs/other-readers.md. Ends with 77 where this machine lacks what it takes."""
import pathlib
import re
import sys
import tempfile

import cases
import judge
import numpy
import pictures
import readers


def expect_agreement(rows):
    failed = [row.line() for row in rows if row.verdict not in readers.WELL]
    assert not failed, "\n".join(["other readers differ:", *failed])


def test_meshes(tracer):
    with tempfile.TemporaryDirectory() as out:
        expect_agreement(readers.judge_cases(tracer, pathlib.Path(out), [case for case in cases.ALL if case.quick]))


def test_pictures(tracer):
    expect_agreement(readers.judge_pictures(tracer, [kind for kind in pictures.ALL if kind.quick]))


def test_page(_):
    page = (judge.HERE.parent.parent / "docs/other-readers.md").read_text(encoding="utf-8")
    rows = set(re.findall(r"^\| (\w+/\w+) \|", page, re.MULTILINE))
    files = {one.name for one in (*cases.ALL, *pictures.ALL)}
    assert rows == files, f"docs/other-readers.md lacks {files - rows}, and has {rows - files}, which is none"


def test_judge(tracer):
    """Files that are read rightly, and then something else in the place of ours."""
    mistakes = {
        "turned texture": lambda folder: cases.gltf_square(cases.paint().rotate(90)).write(folder / "wrong.gltf"),
        "darker": lambda folder: cases.gltf_square(color=(0.9, 0.9, 0.9, 1)).write(folder / "wrong.gltf"),
        "another shape": cases.obj_plain,
    }
    with judge.Three() as three, tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        right = cases.gltf_texture(folder)
        theirs, scale, position = three.draw(right)

        def agrees_with(file):
            ours = judge.draw_mesh(tracer, file, scale, position, folder).pixels
            return judge.compare(ours, theirs).agrees

        assert agrees_with(right)
        for mistake, write in mistakes.items():
            assert not agrees_with(write(folder)), f"not seen: {mistake}"
        assert not judge.compare(numpy.roll(theirs, 1, axis=1), theirs).agrees, "not seen: all moved by a pixel"
        try:
            three.draw(pathlib.Path(__file__))
        except RuntimeError as error:
            assert "no loader" in str(error)
        else:
            raise AssertionError("three.js drew what is no mesh")


def test_picture_judge(tracer):
    """A picture, and then one that the file does not have."""
    texels = pictures.noise()
    for written, wrong in ((texels, 0), (numpy.roll(texels, 1, axis=0), 1)):
        kind = pictures.Kind("png/unreadable", lambda: (pictures.png_rgb()[0], written), 1, False, "")
        with tempfile.TemporaryDirectory() as folder:
            found = pictures.judge_picture(tracer, kind, pathlib.Path(folder))
        assert round(found.wrong, 1) == wrong, found


if __name__ == "__main__":
    if sys.argv[2] in ("meshes", "judge") and not judge.find_three():
        print("left out: docs/node_modules has no three.js, which ./stagelight readers installs")
        sys.exit(77)
    globals()[f"test_{sys.argv[2]}"](pathlib.Path(sys.argv[1]))
