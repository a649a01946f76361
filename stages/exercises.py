#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""exercises.py BUILD list | status | reset STAGE K [--yes] | prove [STAGE] | STAGE K [--solution]

An exercise of a stage is a folder stages/NN_name/exercises/K_title with
  README.md    the task, its third line the time that it takes and how hard it is, and hints in steps;
  exercise.cl  regions of the kernels, each below a comment that names its file. Where the student has something to
               write, stub and solution stand one after the other:
                   // #stub
                       return INFINITY;  // your turn
                   // #solution
                       return t > 0.0f ? t : INFINITY;
                   // #end
  test.py      check(attempt), which raises Wrong until the task is done.
A core exercise, stages/NN_name/core/K_title, asks for a function of the course itself, in the chapter's order. Its
exercise.cl has stubs only: the solution is what the kernels have in these regions. Its test.py has MISTAKES that
students make, each a text of these regions, what takes its place, and a sentence that tells the student of it.
An attempt whose picture is that of such a mistake gets the sentence. Scenes of several are in core_scenes.py.
The student works on work/NN_name/K_title.cl, or title.cl of a core exercise. Git ignores work. The file begins as the
stub, without the solution. STAGE K names an exercise, K being its number or title; a core exercise has a title only.
An attempt is the stage's program with the kernels in which these regions are replaced. What its pictures
must be is worked out in test.py with NumPy, in double, or measured on the picture: never by a kernel.
"""
import concurrent.futures
import datetime
import functools
import hashlib
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

import numpy as np
import OpenImageIO as oiio

ROOT = Path(__file__).resolve().parent.parent
SIZE = (160, 96)
LIMIT = 120  # seconds that a program may take
MISTAKES = 5  # that a core exercise knows, at the least


class Wrong(Exception):
    """What the task asks for is not there: a text, and where a picture shows it, the one expected."""

    def __str__(self):
        return self.args[0]


class DoesNotRun(Exception):
    """The program ends with an error: its message. Or it can't be made of the file: where, and what was expected."""


# --- What tests expect with

def rays(scene, size=SIZE):
    """The eye, and of each pixel's centre the direction seen along, (height, width, 3) in world space: docs/shading.md,
    "The camera"."""
    camera = tomllib.loads(scene_text(scene))["camera"]
    width, height = size
    eye = np.array(camera["position"], float)
    forward = unit(np.array(camera["look_at"], float) - eye)
    right = unit(np.cross(forward, np.array(camera.get("up", [0, 1, 0]), float)))
    up = np.cross(right, forward)
    half = np.tan(np.radians(camera["fov"]) / 2)
    x = half * (2 * (np.arange(width) + 0.5) / width - 1)
    y = half * height / width * (1 - 2 * (np.arange(height) + 0.5) / height)
    return eye, unit(forward + x[None, :, None] * right + y[:, None, None] * up)


def unit(a):
    return a / np.linalg.norm(a, axis=-1, keepdims=True)


def dot(a, b):
    return np.sum(a * b, axis=-1)


def hit_sphere(origin, direction, center, radius):
    """Distances along unit directions, (…,); inf where there is no hit. The quadratic equation, in double."""
    to_eye = origin - np.array(center, float)
    b = dot(to_eye, direction)
    root = b * b - dot(to_eye, to_eye) + radius * radius
    with np.errstate(invalid="ignore"):
        near, far = -b - np.sqrt(root), -b + np.sqrt(root)
    distance = np.where(near > 1e-6, near, far)
    return np.where((root >= 0) & (distance > 1e-6), distance, np.inf)


def hit_plane(origin, direction, normal, point):
    """Distances along unit directions, (…,); inf where there is no hit."""
    normal = unit(np.array(normal, float))
    with np.errstate(divide="ignore", invalid="ignore"):
        distance = dot(np.array(point, float) - origin, normal) / dot(direction, normal)
    return np.where(distance > 1e-6, distance, np.inf)


def triangles_of(text):
    """Of an OBJ file's text: the corners of its triangles and the normals there, (n, 3, 3) each. Quadrilaterals are
    parted from their first corner on, as Assimp does it."""
    lines = [line.split() for line in text.splitlines()]
    positions, normals = (np.array([line[1:] for line in lines if line[:1] == [key]], float) for key in ("v", "vn"))
    corners = []
    for face in ([corner.split("/") for corner in line[1:]] for line in lines if line[:1] == ["f"]):
        corners += [[face[0], second, third] for second, third in zip(face[1:], face[2:])]
    pick = [[[int(corner[i]) - 1 for corner in triangle] for triangle in corners] for i in (0, 2)]
    return positions[pick[0]], normals[pick[1]]


def hit_triangles(origin, direction, corners):
    """Distances along the directions, (…,), inf where there is no hit; which triangle, and the weights of its three
    corners there: each by its three equations, solved in double."""
    shape = np.broadcast(origin, direction).shape[:-1]
    distance, index, weights = np.full(shape, np.inf), np.full(shape, -1), np.zeros(shape + (3,))
    for number, (a, b, c) in enumerate(corners):
        columns = np.broadcast_arrays(-direction, b - a, c - a)
        matrix = np.stack(columns, axis=-1)
        matrix[np.abs(np.linalg.det(matrix)) < 1e-15] = np.nan  # along the plane: no hit
        to_origin = np.broadcast_to(origin - a, shape + (3,))[..., None]
        t, second, third = np.moveaxis(np.linalg.solve(matrix, to_origin)[..., 0], -1, 0)
        hit = (t > 1e-9) & (t < distance) & (second >= 0) & (third >= 0) & (second + third <= 1)
        distance[hit], index[hit] = t[hit], number
        weights[hit] = np.stack([1 - second - third, second, third], axis=-1)[hit]
    return distance, index, weights


def closest(scene, origin, direction):
    """What rays with unit directions hit of the scene's spheres and planes: distance (inf: nothing), unit normal
    turned to the eye, and index, spheres first, then planes (-1: nothing)."""
    described = tomllib.loads(scene_text(scene))
    distance = np.full(np.broadcast(origin, direction).shape[:-1], np.inf)
    normal = np.zeros(distance.shape + (3,))
    index = np.full(distance.shape, -1)
    shapes = described.get("spheres", []) + described.get("planes", [])
    for number, shape in enumerate(shapes):
        if "center" in shape:
            t = hit_sphere(origin, direction, shape["center"], shape["radius"])
            finite = np.where(np.isfinite(t), t, 0)[..., None]
            n = unit(origin + finite * direction - np.array(shape["center"], float))
        else:
            t = hit_plane(origin, direction, shape["normal"], shape["point"])
            n = np.broadcast_to(unit(np.array(shape["normal"], float)), normal.shape)
        nearer = t < distance
        distance[nearer], normal[nearer], index[nearer] = t[nearer], n[nearer], number
    normal = np.where(dot(normal, direction)[..., None] > 0, -normal, normal)
    return distance, normal, index


def texels_of(picture):
    """Of a picture of scenes/, its values from 0 to 1, (height, width, 3)."""
    return oiio.ImageInput.open(str(ROOT / "scenes" / picture)).read_image(oiio.FLOAT).astype(float)[..., :3]


def bilinear(texels, u, v):
    """The colours at texture coordinates, (…,) each: docs/shading.md, "Textures"."""
    height, width = texels.shape[:2]
    x, y = u * width - 0.5, v * height - 0.5
    column, row = np.floor(x).astype(int), np.floor(y).astype(int)
    across, down = (x - column)[..., None], (y - row)[..., None]
    rows = [(1 - across) * texels[j % height, column % width] + across * texels[j % height, (column + 1) % width]
            for j in (row, row + 1)]
    return (1 - down) * rows[0] + down * rows[1]


def normals_and_distances(scene, distance, normal):
    """What stage 01 makes of closest hits: docs/shading.md, "Stage 01"."""
    seen = np.isfinite(distance)
    t = np.where(seen, distance, 0)
    darkening = 0.2 * (0.5 - 0.5 * np.cos(2 * np.pi * t)) / (1 + t * t / 50)
    background = tomllib.loads(scene_text(scene)).get("background", {}).get("color", [0, 0, 0])
    return np.where(seen[..., None], (0.5 + 0.5 * normal) * (1 - darkening)[..., None], background)


@functools.lru_cache  # prove asks again for each mistake
def first_hits(scene, size=SIZE):
    """What stage 01 draws."""
    distance, normal, _ = closest(scene, *rays(scene, size))
    return normals_and_distances(scene, distance, normal)


def light_at(scene, position, normal, corners=()):
    """What lights bring to points (n, 3): the sum over those that are seen, of Lambert's cosine times irradiance. The
    scene's shapes are in the way, and the triangles (m, 3, 3)."""
    total = np.zeros(position.shape)
    for light in tomllib.loads(scene_text(scene)).get("lights", []):
        irradiance = light.get("intensity", 1) * np.array(light.get("color", [1, 1, 1]), float)
        way = light["position"] - position if light["type"] == "point" else \
            np.broadcast_to(-np.array(light["direction"], float), position.shape)
        far = np.linalg.norm(way, axis=-1) if light["type"] == "point" else np.full(len(position), np.inf)
        to_light = unit(way)
        if light["type"] == "point":
            window = np.maximum(0, 1 - (far / light.get("range", np.inf)) ** 4) ** 2
            irradiance = irradiance * (window / far ** 2)[..., None]
        cosine = dot(normal, to_light)
        blocker = np.minimum(closest(scene, position, to_light)[0], hit_triangles(position, to_light, corners)[0])
        seen = (cosine > 0) & ~(blocker < far)
        total += np.where(seen, cosine, 0)[..., None] * irradiance
    return total


def light_along(scene, origin, direction, depth=0, absorption=(0, 0, 0)):
    """What rays (n, 3) bring back in stages 02 to 04, in a scene of spheres and planes: docs/shading.md. The eye is not
    in glass, and no glass is in other glass."""
    described = tomllib.loads(scene_text(scene))
    distance, normal, index = closest(scene, origin, direction)
    absorption = np.array(absorption, float)
    with np.errstate(invalid="ignore"):
        left = np.where(absorption > 0, np.exp(-absorption * distance[..., None]), 1)
    color = left * described.get("background", {}).get("color", [0, 0, 0])
    ends = depth >= described.get("trace", {}).get("max_depth", 8)

    def further(position, way, absorption):
        return np.zeros(way.shape) if ends else light_along(scene, position, way, depth + 1, absorption)

    for number, shape in enumerate(described.get("spheres", []) + described.get("planes", [])):
        material = described.get("materials", {}).get(shape.get("material"), {"type": "diffuse"})
        outward = origin + np.where(index == number, distance, 0)[..., None] * direction - shape["center"] \
            if "center" in shape else np.array(shape["normal"], float)
        for inside in (False, True):
            met = (index == number) & ((dot(outward, direction) > 0) == inside)
            if not met.any():
                continue
            position, way, n = (origin + distance[..., None] * direction)[met], direction[met], normal[met]
            reflected = way - 2 * dot(way, n)[..., None] * n
            if material["type"] == "dielectric":
                beyond = (0, 0, 0) if inside else material.get("absorption", (0, 0, 0))
                share, refracted = split(way, n, material.get("ior", 1.5), inside)
                sent = share * further(position, reflected, absorption)
                through = share[..., 0] < 1
                sent[through] += (1 - share[through]) * further(position[through], refracted[through], beyond)
            else:
                share = {"mirror": 1, "glossy": material.get("specularity", 0.5)}.get(material["type"], 0)
                sent = (1 - share) * light_at(scene, position, n) if share < 1 else 0
                sent = sent + (share * further(position, reflected, absorption) if share else 0)
            color[met] = left[met] * material.get("color", [1, 1, 1]) * sent
    return color


def split(direction, normal, ior, inside):
    """At a surface of glass: the share that is reflected, (n, 1), by Schlick, and the directions of the rest."""
    ratio = ior if inside else 1 / ior
    cosine = -dot(direction, normal)
    squared = 1 - ratio * ratio * (1 - cosine * cosine)
    beyond = np.sqrt(np.maximum(squared, 0))
    refracted = unit(ratio * direction + (ratio * cosine - beyond)[..., None] * normal)
    head_on = ((1 - ior) / (1 + ior)) ** 2
    share = head_on + (1 - head_on) * (1 - (beyond if ratio > 1 else cosine)) ** 5
    return np.where(squared < 0, 1, share)[..., None], refracted


@functools.lru_cache
def with_mesh(scene, mesh, size=SIZE):
    """The picture of a scene in which all is white and diffuse, with the mesh of an OBJ file's text, in stage 05."""
    eye, direction = rays(scene, size)
    corners, normals = triangles_of(mesh)
    distance, normal, _ = closest(scene, eye, direction)
    nearer, index, weights = hit_triangles(eye, direction, corners)
    a, b, c = np.moveaxis(corners[index], -2, 0)
    blended = np.sum(weights[..., None] * normals[index], axis=-2)
    facet = np.cross(b - a, c - a)
    facet *= np.sign(dot(facet, blended))[..., None]
    blended *= -np.sign(dot(facet, direction))[..., None]
    is_mesh = nearer < distance
    seen = np.isfinite(np.minimum(nearer, distance))
    normal = np.where(is_mesh[..., None], blended, normal)[seen]
    position = eye + np.minimum(nearer, distance)[seen][..., None] * direction[seen]
    color = np.empty(direction.shape)
    color[:] = tomllib.loads(scene_text(scene)).get("background", {}).get("color", [0, 0, 0])
    color[seen] = light_at(scene, position, unit(normal), corners)
    return color


@functools.lru_cache  # prove asks again for each mistake
def traced(scene, size=SIZE):
    """The picture of a scene of spheres and planes, in stages 02 to 04."""
    eye, direction = rays(scene, size)
    flat = direction.reshape(-1, 3)
    return light_along(scene, np.broadcast_to(eye, flat.shape), flat).reshape(direction.shape)


def reflectance(scene, index):
    """The materials' colours of what closest() found; black where there is nothing."""
    described = tomllib.loads(scene_text(scene))
    colors = [described["materials"][shape["material"]]["color"]
              for shape in described.get("spheres", []) + described.get("planes", [])]
    return np.array(colors + [[0, 0, 0]], float)[index]


def lit_by(scene, *lights):
    """The text of a scene, whose lights come last, with other lights: the number of one of its own, or one's keys."""
    rest, *own = scene_text(scene).split("[[lights]]\n")
    return "[[lights]]\n".join([rest] + [own[light] if isinstance(light, int) else light for light in lights])


def expect(condition, what):
    if not condition:
        raise Wrong(what)


def scene_text(scene):
    """A scene is a file of scenes/, or itself the text of one."""
    return scene if "\n" in scene else (ROOT / "scenes" / scene).read_text()


# --- An attempt

class Attempt:
    """The program of the exercise's stage, with the regions of a part of the file in its kernels. Of the exercise's
    test, OPTIONS are given with each picture, and prepare(kernels) changes what the picture shows."""

    def __init__(self, build, exercise, file, part, scratch, test=None):
        self.program = build / "stages" / exercise.parent.parent.name
        self.exercise = exercise
        self.scratch = scratch
        self.kernels = scratch / "attempt"
        # Kernels built by an earlier run would hide no mistake, but these folders are not for keeps.
        self.environment = os.environ | {"POCL_CACHE_DIR": str(build / "pocl_cache_exercises")}
        self.options = tuple(getattr(test, "OPTIONS", ()))
        self.drawn = None  # the last picture, and how it was drawn
        copy_kernels(self.kernels)
        if not (is_core(exercise) and part == "solution"):  # which is the kernels' own
            replace_regions(self.kernels, file, part)
        if hasattr(test, "prepare"):
            test.prepare(self.kernels)
        # One ray in a work-item, as on a GPU, is drawn without these.
        self.has_packets = any(target.startswith("kernels/packets/") for target, *_ in regions_of(file, part))

    def render(self, *options, scene=None, size=SIZE, original=False):
        """The picture, linear, (height, width, 3); of the stage's default scene where none is named. original: as
        the course's own kernels draw it."""
        picture = self.scratch / "picture.exr"
        self.draw(picture, *options, scene=scene, size=size, original=original)
        # Not as an ImageBuf: its cache takes a file written within the same second for the one before.
        pixels = np.array(oiio.ImageInput.open(str(picture)).read_image(oiio.FLOAT), float)[..., :3]
        self.drawn = pixels, options, {"scene": scene, "size": size}
        return pixels

    def draw(self, picture, *options, scene=None, size=SIZE, original=False):
        """A file, PNG or EXR."""
        command = [self.program]
        if scene:
            path = self.scratch / "scene.toml"
            path.write_text(scene_text(scene))
            command.append(path)
        command += ["--size", f"{size[0]}x{size[1]}", "--out", picture, "--display", "none",
                    *map(str, self.options + options)]
        if self.has_packets and not any("width=" in str(option) for option in options):
            command += ["--method", "width=16"]
        if not original:
            command += ["--kernels", self.kernels]
        environment = self.environment | {"STAGELIGHT_ASSETS": str(ROOT / "scenes")}
        try:
            done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=LIMIT)
        except subprocess.TimeoutExpired:
            raise DoesNotRun(f"the program does not end within {LIMIT} s") from None
        if done.returncode:
            raise DoesNotRun(done.stderr.strip() or f"the program ended with {done.returncode} and no word: a crash")

    def expect_each(self, scenes, truth):
        """Of each scene, which comes with what it is in words, the picture that truth(scene) works out."""
        for scene, what in scenes:
            self.expect_same(self.render(scene=scene), truth(scene), what)

    def expect_same(self, picture, expected, what, tolerance=2e-3, strays=0.01):
        """Each pixel within the tolerance, but for a share of strays: float and double part at edges. All three
        pictures are left in out/exercises/ where they differ."""
        difference = np.abs(picture - expected).max(axis=-1)
        wrong = ~(difference <= tolerance)  # NaN is wrong
        if wrong.mean() <= strays:
            return
        folder = Path("out/exercises") / f"{self.exercise.parts[-3]}_{file_name_of(self.exercise)}"
        write_png(folder / "yours.png", picture)
        write_png(folder / "expected.png", expected)
        write_png(folder / "difference.png", np.repeat(difference[..., None], 3, axis=-1))
        y, x = np.unravel_index(np.argmax(np.nan_to_num(difference, nan=np.inf)), difference.shape)
        raise Wrong(f"{what}: {wrong.sum()} of {wrong.size} pixels differ by more than {tolerance:g}; the worst, at "
                    f"({x}, {y}), is {rounded(picture[y, x])} and should be {rounded(expected[y, x])}; see {folder}",
                    expected)


def rounded(color):
    return "(" + ", ".join(f"{c:.4g}" for c in color) + ")"


def write_png(path, picture):
    """As sRGB (IEC 61966-2-1)."""
    path.parent.mkdir(parents=True, exist_ok=True)
    linear = np.clip(np.nan_to_num(picture), 0, 1)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    height, width = picture.shape[:2]
    image = oiio.ImageBuf(oiio.ImageSpec(width, height, 3, oiio.UINT8))
    image.set_pixels(oiio.ROI(), np.ascontiguousarray(encoded, np.float32))
    image.write(str(path))


def copy_kernels(folder):
    for pattern in ("kernels/**/*.cl", "kernels/*.inc", "kernels/*.h", "stages/*/kernel.cl"):
        for file in ROOT.glob(pattern):
            copy = folder / file.relative_to(ROOT)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, copy)


MARK_AFTER = {None: "stub", "stub": "solution", "solution": "end"}


def part_of(file, part):
    """The lines of a part, stub or solution, with their numbers: the shared ones and its own. A mark is alone on its
    line, in a comment of any language."""
    lines, place, since = [], None, 0
    for number, line in enumerate(file.read_text().splitlines(), 1):
        if not (mark := re.fullmatch(r"\W*#(stub|solution|end)\W*", line)):
            if place in (None, part):
                lines.append((number, line))
        elif mark[1] == MARK_AFTER[place]:
            place, since = None if mark[1] == "end" else mark[1], number
        else:
            raise DoesNotRun(f"{file.relative_to(ROOT)}:{number}: #{mark[1]}: expected #{MARK_AFTER[place]} before it")
    if place:
        raise DoesNotRun(f"{file.relative_to(ROOT)}:{since}: #{place}: expected #{MARK_AFTER[place]} after it")
    return lines


def regions_of(file, part):
    """File, region, its lines with their numbers."""
    regions, target, name = [], None, None
    for number, line in part_of(file, part):
        if name is None and (mark := re.fullmatch(r"// ((?:kernels|stages)/[\w./]+)", line)):
            target = mark[1]
        elif name is None and (mark := re.fullmatch(r"// #region (\w+)", line)) and target:
            name = mark[1]
            regions.append((target, name, []))
        elif name is not None and line == f"// #endregion {name}":
            name = None
        elif name is not None:
            regions[-1][2].append((number, line))
        elif line and not line.startswith("//"):
            raise DoesNotRun(f"{file.relative_to(ROOT)}:{number}: this line is in no region")
    if name is not None or not regions:
        raise DoesNotRun(f"{file.relative_to(ROOT)}: expected regions, each between #region and #endregion, below "
                         "the name of their file")
    return regions


def replace_regions(folder, file, part):
    """The compiler's messages name the exercise's file."""
    for target, name, lines in regions_of(file, part):
        path = folder / target
        text = path.read_text() if path.is_file() else ""
        start, end = span_of(text, file, target, name)
        body, next_number = [], None
        for number, line in lines:
            if number != next_number:  # the other part was left out
                body.append(f'#line {number} "{file.relative_to(ROOT)}"')
            body.append(line)
            next_number = number + 1
        after = text[:end].count("\n") + 1
        body.append(f'#line {after} "{target}"')
        path.write_text(text[:start] + "\n".join(body) + "\n" + text[end:])


def span_of(text, file, target, name):
    """Where a region's lines begin and end."""
    marks = rf"// #region {name}\n", rf"[ ]*// #endregion {name}\n"
    found = [list(re.finditer(mark, text)) for mark in marks]
    if any(len(matches) != 1 for matches in found):
        raise DoesNotRun(f"{file.relative_to(ROOT)}: {target} has no region {name}")
    return found[0][0].end(), found[1][0].start()


def plant(kernels, file, old, new):
    """One of a core exercise's mistakes, in a copy of the kernels."""
    places = []
    for target, name, _ in regions_of(file, "stub"):
        text = (kernels / target).read_text()
        start, end = span_of(text, file, target, name)
        if (count := text.count(old, start, end)):
            places += [(kernels / target, text[:start] + text[start:end].replace(old, new) + text[end:])] * count
    if len(places) != 1:
        raise DoesNotRun(f"{(file.parent / 'test.py').relative_to(ROOT)}: {old!r} is in its regions {len(places)} "
                         "times, expected once")
    places[0][0].write_text(places[0][1])


class Mistakes:
    """Attempts with the known mistakes of a core exercise, and what they draw."""

    def __init__(self, build, exercise, test, scratch):
        self.sentences, self.attempts, self.drawn = [], [], {}
        for number, (old, new, sentence) in enumerate(getattr(test, "MISTAKES", ())):
            folder = scratch / str(number)
            folder.mkdir()
            attempt = Attempt(build, exercise, exercise / "exercise.cl", "solution", folder, test)
            plant(attempt.kernels, exercise / "exercise.cl", old, new)
            self.sentences.append(" ".join(sentence.split()))
            self.attempts.append(attempt)

    def likeliest(self, attempt, expected=None):
        """The sentence of the mistake that draws the attempt's last picture, or None. Few pixels may differ, and far
        fewer than from what was expected: a mistake that this scene doesn't show explains nothing."""
        if expected is None:
            return None
        picture, options, how = attempt.drawn
        nearest = min(0.01, differing(picture, expected) / 4)
        found = None
        for number, sentence in enumerate(self.sentences):
            key = number, options, how["scene"], how["size"]
            if key not in self.drawn:
                for mesh in attempt.scratch.glob("*.obj"):  # of the test's own making
                    if attempt is not self.attempts[number]:
                        shutil.copy(mesh, self.attempts[number].scratch)
                self.drawn[key] = self.attempts[number].render(*options, **how)
            if (share := differing(picture, self.drawn[key])) < nearest:
                nearest, found = share, sentence
        return found


def differing(picture, other, tolerance=2e-3):
    """The share of pixels."""
    both = np.isclose(picture, other, rtol=tolerance, atol=tolerance, equal_nan=True)
    return 1 - both.all(axis=-1).mean()


# --- The commands

def is_core(exercise):
    return exercise.parent.name == "core"


def title_of(exercise):
    return exercise.name.split("_", 1)[1]


def file_name_of(exercise):
    """Of the student's file, without its ending."""
    return title_of(exercise) if is_core(exercise) else exercise.name


def exercises(stage=None):
    """Folders, a stage's core exercises first; of one stage, by its number or name, or of all."""
    found = [folder for kind in ("core", "exercises") for folder in ROOT.glob(f"stages/[0-9][0-9]_*/{kind}/[0-9]*_*")]
    return sorted((folder for folder in found if stage in (None, folder.parts[-3], folder.parts[-3][:2])),
                  key=lambda folder: (folder.parts[-3], not is_core(folder), folder.name))


def address_of(exercise):
    """The word that stands for it after its stage's number."""
    return title_of(exercise) if is_core(exercise) else exercise.name.split("_")[0]


def effort_of(exercise):
    """Minutes, and how hard it is."""
    file = exercise / "README.md"
    line = (file.read_text().splitlines() + [""] * 3)[2]
    if not (effort := re.fullmatch(r"\*(\d+) minutes, (easy|moderate|hard)\*", line)):
        raise DoesNotRun(f"{file.relative_to(ROOT)}:3: {line!r}: expected *N minutes, easy*, or moderate or hard")
    return int(effort[1]), effort[2]


def copy_of(exercise):
    return ROOT / "work" / exercise.parts[-3] / f"{file_name_of(exercise)}.cl"


def stub_of(exercise):
    return "".join(f"{line}\n" for _, line in part_of(exercise / "exercise.cl", "stub"))


def students_copy(exercise):
    """Begun from the stub where it is not there yet."""
    copy = copy_of(exercise)
    if not copy.exists():
        text = stub_of(exercise)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(text)
    return copy


def test_of(exercise):
    spec = importlib.util.spec_from_file_location("test", exercise / "test.py")
    test = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(test)
    return test


def try_out(build, exercise, file, part):
    """Raises Wrong or DoesNotRun where the exercise's test does. Wrong says which mistake it looks like."""
    test = test_of(exercise)
    with tempfile.TemporaryDirectory() as scratch:
        attempt = Attempt(build, exercise, file, part, Path(scratch), test)
        try:
            test.check(attempt)
        except Wrong as error:
            folder = Path(scratch) / "mistakes"
            folder.mkdir()
            sentence = Mistakes(build, exercise, test, folder).likeliest(attempt, *error.args[1:])
            raise Wrong("\n".join(filter(None, (str(error), sentence))), *error.args[1:]) from None


def picture_of(build, exercise, file, part):
    """The stage's default scene, as the attempt draws it."""
    with tempfile.TemporaryDirectory() as scratch:
        attempt = Attempt(build, exercise, file, part, Path(scratch), test_of(exercise))
        path = Path("out/exercises") / f"{exercise.parts[-3]}_{file_name_of(exercise)}.png"
        path.parent.mkdir(parents=True, exist_ok=True)
        attempt.draw(path, size=(640, 384))
    return path


def name_of(exercise):
    return f"{exercise.parts[-3][:2]} {file_name_of(exercise)}"


def show(build, exercise, file, part):
    """Builds, draws, opens and tests an attempt."""
    try:
        path = picture_of(build, exercise, file, part)
        print(f"{name_of(exercise)}: {path}")
        if "DISPLAY" in os.environ and shutil.which("xdg-open"):
            subprocess.Popen(["xdg-open", path], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try_out(build, exercise, file, part)
    except (Wrong, DoesNotRun) as error:
        print(error)
        print(f"Not yet. The task and its hints: {(exercise / 'README.md').relative_to(ROOT)}; what to change: "
              f"{file.relative_to(ROOT)}")
        return 1
    if file == copy_of(exercise):
        note_passed(exercise)
    print("Done: the test passes.")
    return 0


# --- What the student has done: work/passed.json, by the exercise's name the date, and a hash of the file that passed

def passed():
    file = ROOT / "work" / "passed.json"
    return json.loads(file.read_text()) if file.exists() else {}


def hash_of(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()


def note_passed(exercise):
    today = datetime.date.today().isoformat()
    all_passed = passed() | {name_of(exercise): {"date": today, "sha256": hash_of(copy_of(exercise))}}
    (ROOT / "work" / "passed.json").write_text(json.dumps(all_passed, indent=1) + "\n")


def state_of(exercise, all_passed):
    copy = copy_of(exercise)
    if not copy.exists():
        return ""
    if not (note := all_passed.get(name_of(exercise))):
        return "begun"
    return f"{'done' if note['sha256'] == hash_of(copy) else 'changed since it passed'} on {note['date']}"


def in_order(chosen):
    """A stage's core exercises as the chapter has them, then the others, short ones first."""
    return sorted(chosen, key=lambda e: (e.parts[-3], (0, e.name) if is_core(e) else (1, effort_of(e)[0], e.name)))


def describe(exercise, last):
    minutes, difficulty = effort_of(exercise)
    print(f"{name_of(exercise):24} {minutes:3} min  {difficulty:8}  {last}".rstrip())


def list_all():
    for exercise in in_order(exercises()):
        title = (exercise / "README.md").read_text().splitlines()[0].lstrip("# ")
        describe(exercise, re.sub(r"^(\d+\.|\w+:) ", "", title))
    return 0


def status():
    all_passed = passed()
    chosen = in_order(exercises())
    states = [state_of(exercise, all_passed) for exercise in chosen]
    for exercise, state in zip(chosen, states):
        describe(exercise, state)
    done = [effort_of(exercise)[0] for exercise, state in zip(chosen, states) if state.startswith("done")]
    print(f"{len(done)} of {len(chosen)} done: {sum(done)} of {sum(effort_of(e)[0] for e in chosen)} minutes")
    return 0


def reset(exercise, sure):
    """The student's file is the stub again. Asks before it throws work away."""
    copy = copy_of(exercise)
    where = copy.relative_to(ROOT)
    if not copy.exists() or copy.read_text() == stub_of(exercise):
        print(f"{where}: nothing to reset")
        return 0
    if not sure:
        if not sys.stdin.isatty():
            print(f"stagelight: exercise reset: {where} has work of yours: copy it elsewhere, then give --yes",
                  file=sys.stderr)
            return 2
        if input(f"{where} has work of yours. Throw it away? [y/N] ").strip().lower() not in ("y", "yes"):
            print("kept")
            return 0
    copy.unlink()
    students_copy(exercise)
    print(f"{where} is the stub again")
    return 0


# --- Whether the exercises themselves are right

def prove_one(build, exercise):
    """What is wrong with the exercise itself, if anything is; else what its stub fails by."""
    try:
        effort_of(exercise)
    except DoesNotRun as error:
        return str(error), None
    try:
        try_out(build, exercise, exercise / "exercise.cl", "stub")
        return "the stub passes", None
    except DoesNotRun as error:
        return f"the stub does not run: {error}", None
    except Wrong as error:
        failed_by = str(error).splitlines()[0]
    try:
        try_out(build, exercise, exercise / "exercise.cl", "solution")
        if problem := is_core(exercise) and prove_mistakes(build, exercise):
            return problem, None
    except (Wrong, DoesNotRun) as error:
        return f"the solution fails: {error}", None
    return None, failed_by


def prove_mistakes(build, exercise):
    """Each of a core exercise's mistakes fails the test, and gets its own sentence. None, or what is wrong."""
    test = test_of(exercise)
    if len(test.MISTAKES) < MISTAKES:
        return f"{len(test.MISTAKES)} mistakes: expected {MISTAKES} or more"
    with tempfile.TemporaryDirectory() as scratch:
        mistakes = Mistakes(build, exercise, test, Path(scratch))
        for attempt, sentence in zip(mistakes.attempts, mistakes.sentences):
            try:
                test.check(attempt)
                return f"the test passes the mistake {sentence!r}"
            except DoesNotRun as error:
                return f"the mistake {sentence!r} does not run: {error}"
            except Wrong as error:
                told = mistakes.likeliest(attempt, *error.args[1:])
                if told != sentence:
                    return f"the mistake {sentence!r} is taken for {told!r}: {error}"
    return None


def prove(build, stage):
    failed = 0
    chosen = exercises(stage)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for exercise, (problem, failed_by) in zip(chosen, pool.map(lambda e: prove_one(build, e), chosen)):
            failed += problem is not None
            print(f"{name_of(exercise)}: " + (f"FAILED: {problem}" if problem else f"solved; without, {failed_by}"),
                  flush=True)
    print(f"exercises: {len(chosen) - failed} passed, {failed} failed")
    return 1 if failed or not chosen else 0


def run(build, *arguments):
    if arguments == ("list",):
        return list_all()
    if arguments == ("status",):
        return status()
    if arguments[0] == "prove" and len(arguments) <= 2:
        return prove(build, *arguments[1:] or [None])
    resets = arguments[0] == "reset"
    stage, k, *options = (*arguments[resets:], "", "")[:max(2, len(arguments) - resets)]
    chosen = [e for e in exercises(stage) if k in (address_of(e), title_of(e), e.name)]
    expected = "--yes" if resets else "--solution"
    if len(chosen) != 1 or options not in ([], [expected]):
        print(f"stagelight: exercise {' '.join(arguments)}: expected a stage, a title or number of the list that "
              f"./stagelight exercise shows, and perhaps {expected}", file=sys.stderr)
        return 2
    if resets:
        return reset(chosen[0], bool(options))
    if options:
        return show(build, chosen[0], chosen[0] / "exercise.cl", "solution")
    return show(build, chosen[0], students_copy(chosen[0]), "stub")


def main(build, *arguments):
    try:
        return run(Path(build), *arguments)
    except DoesNotRun as error:
        print(f"stagelight: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.modules["exercises"] = sys.modules["__main__"]  # what test.py imports
    sys.exit(main(*sys.argv[1:]))
