# SPDX-License-Identifier: MIT
"""imprecise.py ROOT COPY least|filter: copies the kernels of ROOT to COPY, changed to what a device may do that is as
imprecise as OpenCL 1.2 allows (section 7.4, single precision): with `least`, division and roots that are not correctly
rounded, and functions that are off; with `filter`, textures filtered with weights of 8 bits, as most GPUs do."""
import pathlib
import re
import shutil
import sys

KERNEL_FILES = ("kernels/**/*.cl", "kernels/*.inc", "kernels/*.h", "stages/*/kernel.cl", "tests/kernels/*.cl")
# Where a "/" divides numbers of the scene. Elsewhere it divides constants or counts.
DIVIDE = ("dielectric", "fresnel/exact", "fresnel/schlick", "light", "plane", "sphere", "sphere/haines",
          "terminator/chiang", "texture_coordinates", "tree", "triangle", "triangle/woop", "packets/beam", "packets/box",
          "packets/hit", "packets/light", "packets/normalise/exact", "packets/sphere", "packets/sphere/haines",
          "packets/terminator/chiang", "packets/triangle", "packets/triangle/woop")
# One unit in the last place of 1, so at most two of any number.
OFF = "(1.0f + 1.1920929e-7f)"
FUNCTIONS = ("sqrt", "rsqrt", "exp", "length", "normalize", "asin", "atan2")


def fail(text):
    sys.exit(f"imprecise.py: {text}")


def replaced(text, old, new, name):
    if text.count(old) != 1:
        fail(f"{name}: expected once: {old}")
    return text.replace(old, new)


def divided(line):
    code, mark, comment = line.partition("//")
    if not code.startswith("#"):
        code = re.sub(r"(\s)/(\s)", rf"\1* {OFF} /\2", code)
    return code + mark + comment


def main(root, copy, what):
    for pattern in KERNEL_FILES:
        for file in root.glob(pattern):
            to = copy / file.relative_to(root)
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, to)
    kernels = copy / "kernels"
    if what == "least":
        for name in DIVIDE:
            file = kernels / f"{name}.cl"
            old = file.read_text(encoding="utf-8")
            new = "".join(divided(line) for line in old.splitlines(keepends=True))
            if new == old:
                fail(f"{file.name}: no division")
            file.write_text(new, encoding="utf-8")
        file = kernels / "real.cl"
        for other in set(kernels.rglob("*.cl")) - {file}:
            text = re.sub(rf"\b({'|'.join(FUNCTIONS)})\(", r"\1_off(", other.read_text(encoding="utf-8"))
            other.write_text(text, encoding="utf-8")
        # Not under the functions' own names, which some drivers define as macros.
        macros = "".join(f"#define {name}_off(...) ({OFF} * {name}(__VA_ARGS__))\n" for name in FUNCTIONS)
        file.write_text(replaced(file.read_text(encoding="utf-8"), "// #endregion real\n",
                                 macros + "// #endregion real\n", file.name), encoding="utf-8")
    elif what == "filter":
        file = kernels / "filtering" / "hand.cl"
        text = replaced(file.read_text(encoding="utf-8"), "const float2 share = texel - 0.5f - low;",
                        "const float2 share = rint((texel - 0.5f - low) * 256.0f) / 256.0f;", file.name)
        (kernels / "filtering" / "sampler.cl").write_text(text, encoding="utf-8")
    else:
        fail(f"'{what}': expected least or filter")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3])
