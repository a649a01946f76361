# SPDX-License-Identifier: MIT
"""Small pictures of all kinds, each written here, on a square that has one pixel for each texel: what Pillow reads beside
what the full tracer draws."""
import dataclasses
import io
import math
import struct
import typing
import zlib

import numpy
from judge import quoted, run_tracer
from PIL import Image, ImageOps

WIDTH, HEIGHT = 23, 17  # rows of 23 texels have to be padded in BMP


@dataclasses.dataclass
class Kind:
    name: str
    make: typing.Callable  # gives the file's bytes, and what is in it where that is known without reading: RGB
    allowed: int  # codes of 255
    quick: bool
    note: str


ALL: list[Kind] = []


def kind(name, *, allowed=1, quick=False, note=""):
    def add(make):
        ALL.append(Kind(name, make, allowed, quick, note))
        return make
    return add


def noise(channels=3):
    """Each texel is another."""
    return numpy.random.default_rng(1).integers(0, 256, (HEIGHT, WIDTH, channels), "uint8")


def slope():
    """For encodings with losses."""
    y, x = numpy.mgrid[:HEIGHT, :WIDTH]
    return numpy.stack([10 * x, 14 * y, 250 - 5 * (x + y)], -1).astype("uint8")


def encoded(image, form, **options):
    stream = io.BytesIO()
    image.save(stream, form, **options)
    return stream.getvalue()


def rgb_of(grey):
    return numpy.repeat(grey[..., None], 3, -1)


# --- PNG

def write_png(rows, depth, color_type, *, interlaced=False, before=b""):
    """`rows` is an array of bytes for each row, or the rows of all passes, each an array."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, depth, color_type, 0, 0, interlaced)
    data = b"".join(b"\0" + numpy.ascontiguousarray(row).tobytes() for row in rows)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + before + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b"")


@kind("png/rgb", quick=True)
def png_rgb():
    return encoded(Image.fromarray(noise()), "PNG"), noise()


@kind("png/rgba")
def png_rgba():
    texels = noise(4)
    texels[..., 3] = numpy.maximum(texels[..., 3], 1)
    return encoded(Image.fromarray(texels), "PNG"), texels[..., :3]


@kind("png/grey")
def png_grey():
    return encoded(Image.fromarray(noise(1)[..., 0]), "PNG"), rgb_of(noise(1)[..., 0])


@kind("png/grey_alpha")
def png_grey_alpha():
    texels = noise(2)
    texels[..., 1] = numpy.maximum(texels[..., 1], 1)
    return encoded(Image.fromarray(texels, "LA"), "PNG"), rgb_of(texels[..., 0])


@kind("png/one_bit")
def png_one_bit():
    return encoded(Image.fromarray(noise(1)[..., 0] > 127), "PNG"), rgb_of(255 * (noise(1)[..., 0] > 127))


@kind("png/palette")
def png_palette():
    return encoded(Image.fromarray(noise()).quantize(200), "PNG"), None


@kind("png/palette_four_bits")
def png_palette_small():
    return encoded(Image.fromarray(noise()).quantize(11), "PNG"), None


@kind("png/palette_transparent")
def png_transparent():
    return encoded(Image.fromarray(noise()).quantize(200), "PNG", transparency=bytes([0] * 50 + [255] * 150)), None


@kind("png/sixteen_bits")
def png_sixteen():
    texels = noise(6)
    return write_png(texels.reshape(HEIGHT, -1), 16, 2), texels[..., ::2]


@kind("png/grey_sixteen_bits")
def png_grey_sixteen():
    texels = noise(2)
    return write_png(texels.reshape(HEIGHT, -1), 16, 0), rgb_of(texels[..., 0])


@kind("png/interlaced")
def png_interlaced():
    passes = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2))
    rows = [row for x, y, dx, dy in passes for row in noise()[y::dy, x::dx] if row.size]
    return write_png(rows, 8, 2, interlaced=True), noise()


@kind("png/gamma_ignored", note="the file's gamma has no say")
def png_gamma():
    gamma = struct.pack(">I", 4) + b"gAMA" + struct.pack(">I", 100000)
    gamma += struct.pack(">I", zlib.crc32(gamma[4:]))
    return write_png(noise().reshape(HEIGHT, -1), 8, 2, before=gamma), noise()


# --- JPEG

@kind("jpeg/full_color", allowed=3)
def jpeg_full():
    return encoded(Image.fromarray(slope()), "JPEG", quality=95, subsampling=0), None


@kind("jpeg/halved_color", allowed=3, note="decoders fill in the halved colour differently")
def jpeg_halved():
    return encoded(Image.fromarray(slope()), "JPEG", quality=95, subsampling=2), None


@kind("jpeg/progressive", allowed=3)
def jpeg_progressive():
    return encoded(Image.fromarray(slope()), "JPEG", quality=95, subsampling=0, progressive=True), None


@kind("jpeg/grey", allowed=3)
def jpeg_grey():
    return encoded(Image.fromarray(slope()[..., 0]), "JPEG", quality=95), None


@kind("jpeg/cmyk", allowed=3)
def jpeg_cmyk():
    return encoded(Image.fromarray(slope()).convert("CMYK"), "JPEG", quality=95, subsampling=0), None


def add_orientation(orientation):
    @kind(f"jpeg/orientation_{orientation}", allowed=3, quick=orientation == 6)
    def jpeg_orientation():
        exif = Image.Exif()
        exif[0x0112] = orientation
        return encoded(Image.fromarray(slope()), "JPEG", quality=95, subsampling=0, exif=exif), None


for value in range(1, 9):
    add_orientation(value)


# --- BMP

def write_bmp(rows, bits, *, header=40, compression=0, masks=(), palette=b"", top_down=False):
    """`rows` are bytes, the picture's upper row first. `masks` are those of red, green, blue and, with a header that has
    it, alpha."""
    lines = [bytes(row) + b"\0" * (-len(bytes(row)) % 4) for row in rows]
    data = b"".join(lines if top_down else reversed(lines))
    return bmp_of(data, bits, header, compression, masks, palette, -HEIGHT if top_down else HEIGHT)


def bmp_of(data, bits, header, compression, masks, palette, height):
    info = struct.pack("<IiiHHIIiiII", header, WIDTH, height, 1, bits, compression, len(data), 2835, 2835,
                       len(palette) // 4, 0)
    mask_bytes = b"".join(struct.pack("<I", mask) for mask in masks)
    if header > 40:
        info += mask_bytes.ljust(16, b"\0") + b"BGRs" + b"\0" * 48  # sRGB
        info = info.ljust(header, b"\0")
    else:
        info += mask_bytes
    offset = 14 + len(info) + len(palette)
    return b"BM" + struct.pack("<IHHI", offset + len(data), 0, 0, offset) + info + palette + data


def packed(texels, widths, shifts, size):
    """Texels of `size` bytes: each channel's upper bits at its place."""
    wide = texels.astype("uint64")
    value = sum((wide[..., i] >> (8 - width)) << shift if width <= 8 else (wide[..., i] * 0x0101) >> (16 - width) << shift
                for i, (width, shift) in enumerate(zip(widths, shifts)))
    return [row.astype(f"<u{size}").tobytes() for row in value]


def spread(texels, widths):
    """What is left of the channels' codes when only their upper bits were kept."""
    most = numpy.array([2 ** min(width, 8) - 1 for width in widths])
    kept = texels >> (8 - numpy.minimum(widths, 8)).astype("uint8")
    return numpy.round(kept * 255.0 / most).astype("uint8")


@kind("bmp/rgb", quick=True)
def bmp_rgb():
    return encoded(Image.fromarray(noise()), "BMP"), noise()


@kind("bmp/palette")
def bmp_palette():
    return encoded(Image.fromarray(noise()).quantize(256), "BMP"), None


@kind("bmp/one_bit")
def bmp_one_bit():
    return encoded(Image.fromarray(noise(1)[..., 0] > 127), "BMP"), None


@kind("bmp/top_down")
def bmp_top_down():
    return write_bmp([row.tobytes() for row in noise()[..., ::-1]], 24, top_down=True), noise()


@kind("bmp/thirty_two_bits")
def bmp_32():
    return write_bmp(packed(noise(), (8, 8, 8), (16, 8, 0), 4), 32), noise()


@kind("bmp/555")
def bmp_555():
    return write_bmp(packed(noise(), (5, 5, 5), (10, 5, 0), 2), 16), spread(noise(), (5, 5, 5))


@kind("bmp/565")
def bmp_565():
    rows = packed(noise(), (5, 6, 5), (11, 5, 0), 2)
    return write_bmp(rows, 16, compression=3, masks=(0xF800, 0x07E0, 0x001F)), spread(noise(), (5, 6, 5))


@kind("bmp/masks_swapped", quick=True)
def bmp_swapped():
    rows = packed(noise(), (8, 8, 8), (0, 8, 16), 4)
    return write_bmp(rows, 32, compression=3, masks=(0xFF, 0xFF00, 0xFF0000)), noise()


@kind("bmp/masks_unusual", quick=True)
def bmp_unusual():
    """Of 10, 11 and 11 bits."""
    rows = packed(noise(), (10, 11, 11), (0, 10, 21), 4)
    return write_bmp(rows, 32, compression=3, masks=(0x3FF, 0x7FF << 10, 0x7FF << 21)), noise()


@kind("bmp/v4")
def bmp_v4():
    rows = packed(noise(), (8, 8, 8), (16, 8, 0), 4)
    return write_bmp(rows, 32, header=108, compression=3, masks=(0xFF0000, 0xFF00, 0xFF)), noise()


@kind("bmp/v5_rgb", quick=True)
def bmp_v5():
    return write_bmp([row.tobytes() for row in noise()[..., ::-1]], 24, header=124), noise()


@kind("bmp/v5_alpha")
def bmp_v5_alpha():
    texels = noise(4)
    texels[..., 3] = numpy.maximum(texels[..., 3], 1)
    rows = packed(texels, (8, 8, 8, 8), (16, 8, 0, 24), 4)
    return write_bmp(rows, 32, header=124, compression=3, masks=(0xFF0000, 0xFF00, 0xFF, 0xFF000000)), texels[..., :3]


@kind("bmp/run_lengths")
def bmp_runs():
    indices = noise(1)[..., 0] // 64 * 64
    data = b""
    for row in indices[::-1]:
        data += b"".join(bytes((1, value)) for value in row) + b"\0\0"
    palette = b"".join(bytes((i, 255 - i, i // 2, 0)) for i in range(256))
    texels = numpy.stack([indices // 2, 255 - indices, indices], -1)
    return bmp_of(data + b"\0\1", 8, 40, 1, (), palette, HEIGHT), texels


# --- TGA

def write_tga(data, kind_of_data, bits, *, flags=0x20, palette=b"", first=0, palette_bits=0):
    """By default its upper row is first."""
    entries = len(palette) // max(1, palette_bits // 8)
    header = struct.pack("<BBBHHBHHHHBB", 0, bool(palette), kind_of_data, first, entries, palette_bits, 0, 0, WIDTH, HEIGHT,
                         bits, flags)
    return header + palette + numpy.ascontiguousarray(data).tobytes()


@kind("tga/rgb", quick=True)
def tga_rgb():
    return encoded(Image.fromarray(noise()), "TGA"), noise()


@kind("tga/rgba")
def tga_rgba():
    texels = noise(4)
    texels[..., 3] = numpy.maximum(texels[..., 3], 1)
    return encoded(Image.fromarray(texels), "TGA"), texels[..., :3]


@kind("tga/grey")
def tga_grey():
    return encoded(Image.fromarray(noise(1)[..., 0]), "TGA"), rgb_of(noise(1)[..., 0])


@kind("tga/grey_alpha", quick=True)
def tga_grey_alpha():
    texels = noise(2)
    texels[..., 1] = numpy.maximum(texels[..., 1], 1)
    return write_tga(texels, 3, 16, flags=0x28), rgb_of(texels[..., 0])


@kind("tga/run_lengths")
def tga_runs():
    return encoded(Image.fromarray(slope() // 64 * 64), "TGA", compression="tga_rle"), slope() // 64 * 64


@kind("tga/upper_row_last")
def tga_upper_last():
    return write_tga(noise()[::-1, :, ::-1], 2, 24, flags=0), noise()


@kind("tga/right_to_left", quick=True)
def tga_right_to_left():
    return write_tga(noise()[:, ::-1, ::-1], 2, 24, flags=0x30), noise()


@kind("tga/fifteen_bits")
def tga_fifteen():
    rows = b"".join(packed(noise(), (5, 5, 5), (10, 5, 0), 2))
    return write_tga(numpy.frombuffer(rows, "uint8"), 2, 16), spread(noise(), (5, 5, 5))


def tga_with_palette(first):
    colors = numpy.random.default_rng(2).integers(0, 256, (100, 3), "uint8")
    indices = noise(1)[..., 0] % 100
    return write_tga(indices + first, 1, 8, palette=colors[:, ::-1].tobytes(), first=first, palette_bits=24), colors[indices]


@kind("tga/palette")
def tga_palette():
    return tga_with_palette(0)


@kind("tga/palette_with_offset", quick=True)
def tga_offset():
    return tga_with_palette(40)


# --- WebP

@kind("webp/lossless")
def webp_lossless():
    return encoded(Image.fromarray(noise()), "WEBP", lossless=True), noise()


@kind("webp/alpha")
def webp_alpha():
    texels = noise(4)
    texels[..., 3] = numpy.maximum(texels[..., 3], 1)
    return encoded(Image.fromarray(texels), "WEBP", lossless=True, exact=True), texels[..., :3]


@kind("webp/with_losses", allowed=3, note="decoders fill in the halved colour differently")
def webp_lossy():
    return encoded(Image.fromarray(slope()), "WEBP", quality=95), None


# --- PNM

def pnm_head(letter, most=None):
    return f"P{letter}\n# made for a test\n{WIDTH} {HEIGHT}\n{most or ''}".strip().encode() + b"\n"


@kind("pnm/rgb", quick=True)
def pnm_rgb():
    return pnm_head(6, 255) + noise().tobytes(), noise()


@kind("pnm/grey")
def pnm_grey():
    return pnm_head(5, 255) + noise(1).tobytes(), rgb_of(noise(1)[..., 0])


@kind("pnm/bits")
def pnm_bits():
    black = noise(1)[..., 0] > 127
    return pnm_head(4) + numpy.packbits(black, axis=1).tobytes(), rgb_of(255 * ~black)


def pnm_words(values):
    return "\n".join(" ".join(map(str, row)) for row in values.reshape(HEIGHT, -1)).encode() + b"\n"


@kind("pnm/rgb_words")
def pnm_rgb_words():
    return pnm_head(3, 255) + pnm_words(noise()), noise()


@kind("pnm/grey_words")
def pnm_grey_words():
    return pnm_head(2, 255) + pnm_words(noise(1)), rgb_of(noise(1)[..., 0])


@kind("pnm/bits_words")
def pnm_bits_words():
    black = noise(1)[..., 0] > 127
    return pnm_head(1) + pnm_words(1 * black), rgb_of(255 * ~black)


@kind("pnm/sixteen_bits")
def pnm_sixteen():
    texels = noise(6)
    return pnm_head(6, 65535) + texels.tobytes(), texels[..., ::2]


@kind("pnm/most_100", allowed=2)
def pnm_hundred():
    texels = noise() % 101
    return pnm_head(6, 100) + texels.tobytes(), numpy.round(texels * 2.55)


# --- Judging

def read_with_pillow(file):
    """RGB codes, and where alpha is 0; turned as the file says."""
    with Image.open(file) as image:
        image = ImageOps.exif_transpose(image)
        if image.mode.startswith("I"):  # Pillow would clip 16 bits
            return rgb_of(numpy.asarray(image).astype("uint32") >> 8), numpy.zeros(image.size[::-1], bool)
        rgba = numpy.asarray(image.convert("RGBA"))
    return rgba[..., :3], rgba[..., 3] == 0


SCENE = """
[image]
size = [{width}, {height}]
[camera]
position = [0, 0, {width}]
look_at = [0, 0, 0]
fov = {fov!r}
[materials.shown]
type = "diffuse"
texture = {picture}
[[meshes]]
file = "square.obj"
scale = [{width}, {height}, 1]
material = "shown"
[[lights]]
type = "directional"
direction = [0, 0, -1]
"""
SQUARE = "v -0.5 -0.5 0\nv 0.5 -0.5 0\nv 0.5 0.5 0\nv -0.5 0.5 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"


@dataclasses.dataclass
class Judged:
    worst: int | None  # codes of 255
    wrong: float  # the share of texels that are further off than is allowed
    said: str


def judge_picture(tracer, this, folder):
    data, written = this.make()
    file = folder / ("a." + this.name.split("/")[0])
    file.write_bytes(data)
    try:
        expected, hidden = read_with_pillow(file)
    except (OSError, ValueError) as error:
        if written is None:
            raise
        expected, hidden = written, numpy.zeros((HEIGHT, WIDTH), bool)
        said = f"Pillow: {error}; compared with what was written"
    else:
        said = ""
        if written is not None and numpy.abs(expected.astype(int) - written).max() > this.allowed:
            said = "Pillow reads it otherwise; compared with what was written"
            expected = written
    height, width = expected.shape[:2]
    (folder / "square.obj").write_text(SQUARE, encoding="utf-8")
    scene = folder / "scene.toml"
    scene.write_text(SCENE.format(width=width, height=height, fov=math.degrees(2 * math.atan(0.5)), picture=quoted(file)),
                     encoding="utf-8")
    drawn = run_tracer(tracer, scene, folder / "ours.png")
    if drawn.code:
        return Judged(None, 1, drawn.said.splitlines()[-1])
    codes = numpy.round(255 * drawn.pixels).astype(int)
    off = numpy.abs(codes - expected.astype(int)).max(-1)[~hidden]
    return Judged(int(off.max()), float((off > this.allowed).mean()), said)
