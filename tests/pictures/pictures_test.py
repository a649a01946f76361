#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# pictures_test.py TEXELS LIBRARY: pictures of every layout of BMP and TGA, and of every Exif
# orientation, hold what Pillow reads, pixel by pixel. Where Pillow can't read a layout the picture
# holds what it was made from.
import itertools
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image, ImageOps

WIDTH, HEIGHT = 7, 5


def rgba(x, y):
    return (36 * x, 63 * y, 255 - 30 * x - 12 * y, 255 - 20 * x - 7 * y)


PICTURE = [[rgba(x, y) for x in range(WIDTH)] for y in range(HEIGHT)]


def shrunk(value, mask):
    """The bits of a channel's value, at the place of `mask`, and the value that they stand for."""
    shift = (mask & -mask).bit_length() - 1
    most = mask >> shift
    bits = value * most // 255
    return bits << shift, bits * 255 // most


def bmp(bits, header, compression, masks=(), top_down=False, size=WIDTH):
    """A BMP of these masks, of red, green, blue and alpha, and the texels it should give."""
    rows, expected = [], []
    for row in PICTURE:
        line, texels = b"", []
        for color in row:
            pixel, texel = 0, [0, 0, 0, 255]
            for channel, mask in enumerate(masks):
                if mask:
                    part, texel[channel] = shrunk(color[channel], mask)
                    pixel |= part
            line += pixel.to_bytes(bits // 8, "little")
            texels.append(tuple(texel))
        rows.append(line + b"\0" * (-len(line) % 4))
        expected.append(texels)
    pixels = b"".join(rows if top_down else reversed(rows))
    info = struct.pack("<IiiHHIIiiII", header, size, -HEIGHT if top_down else HEIGHT, 1, bits,
                       compression, len(pixels), 2835, 2835, 0, 0)
    four = b"".join(struct.pack("<I", mask) for mask in (tuple(masks) + (0,) * 4)[:4])
    if header > 40:
        info += (four + b"BGRs" + bytes(64))[:header - 40] if compression else bytes(header - 40)
    elif compression == 3:
        info += four[:12]
    elif compression == 6:
        info += four
    start = 14 + len(info)
    info += bytes(max(0, header - len(info)))
    return (b"BM" + struct.pack("<IHHI", start + len(pixels), 0, 0, 14 + len(info)) + info + pixels,
            expected)


def palette_bmp(header, bits):
    colors = [(9 * i, 255 - 8 * i, 3 * i) for i in range(1 << min(bits, 4))]
    index = [[(x + 2 * y) % len(colors) for x in range(WIDTH)] for y in range(HEIGHT)]
    rows = []
    for row in reversed(index):
        value = 0
        for i in row:
            value = value << bits | i
        used = -(-WIDTH * bits // 8)
        value <<= 8 * used - WIDTH * bits
        rows.append(value.to_bytes(used, "big") + b"\0" * (-used % 4))
    pixels = b"".join(rows)
    info = struct.pack("<IiiHHIIiiII", header, WIDTH, HEIGHT, 1, bits, 0, len(pixels), 2835, 2835,
                       len(colors), 0) + bytes(header - 40)
    palette = b"".join(bytes((b, g, r, 0)) for r, g, b in colors)
    start = 14 + len(info) + len(palette)
    return (b"BM" + struct.pack("<IHHI", start + len(pixels), 0, 0, start) + info + palette + pixels,
            [[colors[i] + (255,) for i in row] for row in index])


def runs(pixels):
    """Packets as TGA has them: a run of the first two, if they are equal, else pixels as they are."""
    packed = b""
    while pixels:
        count = 1
        while count < min(len(pixels), 128) and pixels[count] == pixels[0]:
            count += 1
        if count > 1:
            packed += bytes((127 + count,)) + pixels[0]
        else:
            while count < min(len(pixels), 128) and pixels[count] != pixels[count - 1]:
                count += 1
            packed += bytes((count - 1,)) + b"".join(pixels[:count])
        pixels = pixels[count:]
    return packed


def tga(kind, is_packed, origin, first=0, entry_bits=24, index_bits=8):
    """A TGA of this kind, and the texels it should give."""
    colors = [(9 * i, 250 - 8 * i, 3 * i) for i in range(12)]
    expected = [[None] * WIDTH for _ in range(HEIGHT)]
    pixels = {}
    for y, x in itertools.product(range(HEIGHT), range(WIDTH)):
        r, g, b, a = PICTURE[y // 2][x // 2]  # with runs
        if kind == "map":
            i = (x // 2 + 3 * y) % len(colors)
            pixels[x, y] = (first + i).to_bytes(index_bits // 8, "little")
            color = colors[i]
            if entry_bits == 16:
                color = tuple(shrunk(c, 31)[1] for c in color)
            expected[y][x] = color + (255,)
        elif kind == "grey":
            pixels[x, y] = bytes((r,))
            expected[y][x] = (r, r, r, 255)
        elif kind == "grey and alpha":
            pixels[x, y] = bytes((r, a))
            expected[y][x] = (r, r, r, a)
        else:
            pixels[x, y] = bytes((b, g, r, a))[:3 if kind == "colors" else 4]
            expected[y][x] = (r, g, b, a if kind == "colors and alpha" else 255)
    columns = range(WIDTH) if not origin & 1 else range(WIDTH - 1, -1, -1)
    rows = range(HEIGHT) if origin & 2 else range(HEIGHT - 1, -1, -1)
    data = [[pixels[x, y] for x in columns] for y in rows]
    # Packets that go over the end of a row are what the specification advises against.
    body = b"".join(runs(row) if is_packed else b"".join(row) for row in data)
    palette = b""
    if kind == "map":
        for r, g, b in colors:
            if entry_bits == 16:
                palette += struct.pack("<H", shrunk(r, 0x7c00)[0] | shrunk(g, 0x3e0)[0]
                                       | shrunk(b, 0x1f)[0])
            else:
                palette += bytes((b, g, r, 255))[:entry_bits // 8]
    number = {"map": 1, "grey": 3, "grey and alpha": 3}.get(kind, 2) + (8 if is_packed else 0)
    bits = {"map": index_bits, "grey": 8, "grey and alpha": 16, "colors": 24}.get(kind, 32)
    alpha = 8 if "alpha" in kind else 0
    name = b"a name"
    return (struct.pack("<BBBHHBHHHHBB", len(name), kind == "map", number, first,
                        len(palette) * 8 // entry_bits, entry_bits if palette else 0, 0, 0, WIDTH,
                        HEIGHT, bits, origin << 4 | alpha) + name + palette + body, expected)


def pictures(library):
    """Name, bytes and expected texels, and whether Pillow reads it."""
    rgb = (0xff0000, 0xff00, 0xff)
    for header in (40, 52, 56, 108, 124):
        alpha = header >= 56
        for masks, bits, pillow in (
                (rgb, 32, True), ((0xff000000, 0xff0000, 0xff00), 32, True),
                ((0xff, 0xff00, 0xff0000), 32, False), ((0x3ff00000, 0xffc00, 0x3ff), 32, False),
                ((0xff0, 0xff00000, 0x7000), 32, False), ((0xf800, 0x7e0, 0x1f), 16, True),
                ((0x7c00, 0x3e0, 0x1f), 16, True), ((0xf00, 0xf0, 0xf), 16, False),
                ((0x1f, 0x7e0, 0xf800), 16, False)):
            yield f"bmp {header} {bits} {masks[0]:x}", *bmp(bits, header, 3, masks), pillow
        for masks, bits in ((rgb + (0xff000000,), 32), ((0xff, 0xff00, 0xff0000, 0xff000000), 32),
                            ((0xff000000, 0xff0000, 0xff00, 0xff), 32),
                            ((0x3ff, 0xffc00, 0x3ff00000, 0xc0000000), 32),
                            ((0xf00, 0xf0, 0xf, 0xf000), 16), ((0x7c00, 0x3e0, 0x1f, 0x8000), 16)):
            if alpha or header == 40:
                yield (f"bmp {header} alpha {bits} {masks[0]:x}",
                       *bmp(bits, header, 3 if alpha else 6, masks), False)
        yield f"bmp {header} 24", *bmp(24, header, 0, rgb), True
        yield f"bmp {header} 24 down", *bmp(24, header, 0, rgb, True), True
        yield f"bmp {header} 32", *bmp(32, header, 0, rgb), True
        yield f"bmp {header} 16", *bmp(16, header, 0, (0x7c00, 0x3e0, 0x1f)), True
        yield f"bmp {header} 32 down", *bmp(32, header, 3, rgb, True), True
        for bits in (1, 4, 8):
            yield f"bmp {header} palette {bits}", *palette_bmp(header, bits), True
    for packed, origin in itertools.product((False, True), range(4)):
        place = f"{'packed ' if packed else ''}{origin}"
        for kind in ("grey", "grey and alpha", "colors", "colors and alpha"):
            yield f"tga {kind} {place}", *tga(kind, packed, origin), True
        for first, bits in itertools.product((0, 1, 39, 200), (16, 24, 32)):
            yield (f"tga map {first} {bits} {place}", *tga("map", packed, origin, first, bits), bits == 24)
        yield (f"tga map of 16 bits {place}", *tga("map", packed, origin, 300, 24, 16), False)
    yield from turned(library)


def turned(library):
    image = Image.new("RGB", (24, 16))
    image.putdata([(10 * x, 15 * y, 40) for y in range(16) for x in range(24)])
    for orientation in range(1, 9):
        exif = Image.Exif()
        exif[0x112] = orientation
        for suffix, options in (("jpg", {"quality": 100, "subsampling": 0}), ("png", {}),
                                ("webp", {"lossless": True})):
            if suffix == "webp" and library == "stb":
                continue
            with tempfile.NamedTemporaryFile(suffix="." + suffix) as file:
                image.save(file.name, exif=exif, **options)
                read = ImageOps.exif_transpose(Image.open(file.name)).convert("RGBA")
                data = Path(file.name).read_bytes()
            texels = [[read.getpixel((x, y)) for x in range(read.width)]
                      for y in range(read.height)]
            yield f"{suffix} orientation {orientation}", data, texels, True


def differences(line, expected, most):
    if line.startswith("error"):
        return line
    width, height, digits = line.split()
    if (int(width), int(height)) != (len(expected[0]), len(expected)):
        return f"is {width}x{height}, not {len(expected[0])}x{len(expected)}"
    texels = bytes.fromhex(digits)
    for i, color in enumerate(itertools.chain(*expected)):
        got = tuple(texels[4 * i:4 * i + 4])
        if max(abs(a - b) for a, b in zip(got, color)) > most:
            return f"texel {i % int(width)}, {i // int(width)} is {got}, not {color}"
    return ""


def pillow_reads(file):
    try:
        image = ImageOps.exif_transpose(Image.open(file)).convert("RGBA")
    except OSError:  # versions differ in what they read
        return None
    return [[image.getpixel((x, y)) for x in range(image.width)] for y in range(image.height)]


def main(program, library):
    faults, count, judged = [], 0, 0
    with tempfile.TemporaryDirectory() as folder:
        cases = []
        for name, data, expected, pillow in pictures(library):
            file = Path(folder) / name.replace(" ", "_")
            file.write_bytes(data)
            read = pillow_reads(file) if pillow else None
            judged += read is not None
            if read not in (None, expected):
                faults.append(f"{name}: Pillow reads another picture than was meant")
            cases.append((name, file, expected))
        lines = subprocess.run([program, *(str(file) for _, file, _ in cases)],
                               capture_output=True, text=True, check=True).stdout.splitlines()
        for (name, _, expected), line in zip(cases, lines, strict=True):
            count += 1
            # Two decoders of one JPEG round in their own ways.
            fault = differences(line, expected, 3 if name.startswith("jpg") else 0)
            if fault:
                faults.append(f"{name}: {fault}")
    print(f"{count} pictures, {judged} read by Pillow too, {len(faults)} faults", *faults, sep="\n")
    return 1 if faults or judged < 100 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
