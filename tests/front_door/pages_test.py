#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pages_test.py ROOT SCRATCH: what ./stagelight show prints of each stage is its kernel, and no kernel has what its
scene has not.

clang compiles the page, and the kernel from its modules with what the stage does not know switched off. Both must
become the same instructions, arguments and memory. Then the same for scenes that lack something: the page is then
without the modules that only serve that, and so is what the compiler makes of the kernel."""
import collections
import pathlib
import re
import subprocess
import sys

ROOT, SCRATCH = map(pathlib.Path, sys.argv[1:])
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "stages"))
import difference  # noqa: E402
import show  # noqa: E402

# By what a scene may lack: the modules that are gone then.
SERVES = {
    ("HAS_SPHERES",): ("sphere.cl", "sphere/", "texture_coordinates.cl"),
    ("HAS_PLANES",): ("plane.cl",),
    ("HAS_TRIANGLES", "HAS_MESH_TEXTURES", "HAS_CUTOUTS", "HAS_VERTEX_COLORS"): ("triangle.cl", "cutout.cl"),
    ("HAS_TEXTURES", "HAS_MESH_TEXTURES", "HAS_WRAPS", "HAS_CUTOUTS"): (
        "texture.cl", "texture_coordinates.cl", "filtering/", "wrap.cl", "cutout.cl"),
    ("HAS_WRAPS",): (),
    ("HAS_CUTOUTS",): ("cutout.cl",),
    ("HAS_VERTEX_COLORS",): (),
    ("HAS_LIGHTS", "HAS_POINT_LIGHT", "HAS_DIRECTIONAL_LIGHT"): ("light.cl", "shadow.cl", "any_hit.cl"),
    ("HAS_MEDIA",): (),
    ("HAS_DIELECTRIC", "HAS_MEDIA"): ("dielectric.cl", "media.cl", "fresnel/", "transmission/"),
    ("HAS_REFLECTION", "HAS_DIELECTRIC", "HAS_MEDIA"): ("reflection.cl", "dielectric.cl"),
}


def host_names():
    """What the host defines for a scene that has nothing."""
    host = (ROOT / "common/device/scene_needs.cpp").read_text()
    table = re.search(r"smallest\[\] = {(.*?)};", host, re.DOTALL)[1]
    names = {name: int(least) for name, least in re.findall(r'{"(\w+)", (\d+)}', table)}
    return names | {"HAS_FMA": 0, "METHOD_INTERIOR_PAPER": 0}


def expanded(path, has_textures, seen):
    """As common/device/kernel_source.cpp puts modules together."""
    if path in seen and path.suffix != ".inc":
        return ""
    seen.add(path)
    text = ""
    for line in path.read_text().splitlines(keepends=True):
        module = re.match(r'#include "(.*)"', line)
        if not module:
            text += line
        elif module[1].startswith("filtering/") and not has_textures:
            text += expanded(ROOT / "kernels/filtering/none.cl", has_textures, seen)
        else:
            text += expanded(ROOT / "kernels" / module[1], has_textures, seen)
    return text


def compiled(name, source, names):
    """What is in the optimised code, all of it in one function, as drivers make it: its instructions, arguments and
    variables. Not how the parts of vectors are put in
    order, which is said in more or in fewer steps; nor the struct Scene, whose members are 0 for what is not there."""
    file = SCRATCH / f"{name}.cl"
    file.write_text(source)
    done = subprocess.run(["clang", "-x", "cl", "-cl-std=CL1.2", "--target=spir64", "-Xclang", "-finclude-default-header",
                           "-D__OPENCL_VERSION__=120", "-O2", "-mllvm", "-inline-threshold=100000", "-Werror", "-S", "-emit-llvm", "-o", "-", file]
                          + [f"-D{key}={value}" for key, value in names.items()], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{name}:\n{done.stderr[:2000]}")
    code = collections.Counter()
    for line in done.stdout.splitlines():
        if line.startswith("  ") and "lifetime" not in line:
            instruction = re.sub(r"^  (%\S+ = )?((tail|musttail) )?", "", line)
            code[instruction if instruction.startswith("alloca") else instruction.split(" ")[0]] += 1
        elif line.startswith("%struct.") and not line.startswith("%struct.Scene "):
            code[line] += 1
        elif line.startswith("define"):
            code[re.sub(r"[%!#]\S+( \S+)?", "", line)] += 1
    del code["shufflevector"]
    return code


class Pages:
    wrong = 0

    def fail(self, text):
        print(text)
        self.wrong += 1

    def compare(self, before, stage, names, without=()):
        name = stage.name + "".join(f".no_{each[4:].lower()}" for each in without)
        names = {key: 0 if key in without else value for key, value in names.items()}
        names["STACK_SIZE"] = names["MAX_DEPTH"] + 1 if names["HAS_DIELECTRIC"] else 1
        page = "".join(line[2:] + "\n" for line in show.page(before, stage, without=without))
        for beside in difference.BESIDE.values():  # which no kernel includes
            page = re.sub(rf"// {beside}.*?(?=\Z|// (kernels|stages)/)", "", page, flags=re.DOTALL)
        for module in SERVES.get(without, ()):
            if f"// kernels/{module}" in page:
                self.fail(f"{name}: {module} is still there")
        kernel = expanded(stage / "kernel.cl", names["HAS_TEXTURES"], set())
        of_page, of_kernel = (compiled(f"{name}.{what}", text, names)
                              for what, text in (("page", page), ("kernel", kernel)))
        if of_page != of_kernel:
            self.fail(f"{name}: the page has {dict(of_page - of_kernel)}, the kernel {dict(of_kernel - of_page)}")


def main():
    pages = Pages()
    names = host_names()
    for before, stage in zip([None, *difference.stages()], difference.stages()):
        number = difference.number_of(stage)
        names |= difference.LEARNT.get(number, {})
        names.pop("PACKETS", None)
        pages.compare(before, stage, names)
        if number == 8:  # all that has a table of its own above
            for without in SERVES:
                pages.compare(before, stage, names, without)
    return 1 if pages.wrong else 0


if __name__ == "__main__":
    sys.exit(main())
