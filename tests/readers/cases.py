# SPDX-License-Identifier: MIT
"""Small mesh files, one a feature and format, each written here. `ALL` has them in the table's order."""
import dataclasses
import io
import json
import math
import re
import struct
import typing
import zipfile

import numpy
from gltf import Gltf, data_uri
from PIL import Image


@dataclasses.dataclass
class Case:
    name: str
    write: typing.Callable  # takes a folder, gives the file to read, or (ours, theirs) where three.js can't read ours
    quick: bool  # one of the few that the tests draw
    message: str | None  # what our one line says, where we don't draw the file
    note: str  # what the table says of it
    known: bool  # whether the note says why the two differ


ALL: list[Case] = []


def case(name, *, quick=False, message=None, note="", known=False):
    def add(write):
        ALL.append(Case(name, write, quick, message, note, known))
        return write
    return add


# --- Shapes that look like nothing else when they are turned, mirrored or cut

CORNERS = numpy.array([(0, 0, 0), (1.5, 0, 0), (0, 1, 0), (0, 0, 0.6)])
FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))  # counter-clockwise from outside
PURE = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1))  # are the same in sRGB and in linear light

STRIP = ((0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1.2, 0), (2, 0, 0), (2.5, 2, 0))
SQUARE = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))
SQUARE_FACES = ((0, 1, 2), (0, 2, 3))
SQUARE_UV = ((0, 1), (1, 1), (1, 0), (0, 0))  # glTF's: v runs down


def facet_normals():
    """Of FACES."""
    normals = [numpy.cross(CORNERS[b] - CORNERS[a], CORNERS[c] - CORNERS[a]) for a, b, c in FACES]
    return [normal / numpy.linalg.norm(normal) for normal in normals]


def separate_faces():
    """Positions and normals with a vertex for each corner of each face."""
    return CORNERS[[index for face in FACES for index in face]], numpy.repeat(facet_normals(), 3, 0)


def paint(size=32):
    """Its four quarters, and what lies in each, differ."""
    y, x = numpy.mgrid[:size, :size]
    picture = numpy.zeros((size, size, 3), numpy.uint8)
    picture[..., 0] = 255 * (x < size // 2)
    picture[..., 1] = 255 * (y < size // 2)
    picture[..., 2] = 255 * x // (size - 1)
    picture[(x // 4 + y // 4) % 4 == 0] = 128
    return Image.fromarray(picture)


def paint_holes(size=32):
    """Alpha of 0, 100 of 255, and 255, in columns."""
    picture = paint(size).convert("RGBA")
    alpha = numpy.zeros((size, size), numpy.uint8)
    alpha[:, size // 4:] = 100
    alpha[: 3 * size // 4, size // 2:] = 255
    picture.putalpha(Image.fromarray(alpha))
    return picture


def png(image):
    stream = io.BytesIO()
    image.save(stream, "PNG")
    return stream.getvalue()


def words(rows):
    return "".join(" ".join(f"{value:g}" for value in row) + "\n" for row in rows)


# --- glTF

def gltf_square(image=None, *, texture=None, sampler=None, coordinates=SQUARE_UV, kind="float32", normalized=False,
                color=(1, 1, 1, 1), **material):
    """A square with a texture in the file itself."""
    gltf = Gltf()
    picture = gltf.picture({"uri": data_uri(png(image or paint()), "image/png")}, sampler)
    more = {"normalized": True} if normalized else {}
    uv = gltf.accessor(coordinates, kind, **more)
    shown = gltf.material(color, {"index": picture, **(texture or {})}, **material)
    mesh = gltf.mesh(SQUARE, numpy.ravel(SQUARE_FACES), material=shown, attributes={"TEXCOORD_0": uv})
    gltf.node(mesh=mesh)
    return gltf


def gltf_solid(**attributes):
    """The tetrahedron with flat normals; `attributes` maps names to (values of each corner, type)."""
    gltf = Gltf()
    positions, normals = separate_faces()
    which = [index for face in FACES for index in face]
    accessors = {"NORMAL": gltf.accessor(normals)}
    for name, (values, kind) in attributes.items():
        more = {} if kind == "float32" else {"normalized": True}
        accessors[name] = gltf.accessor([values[i] for i in which], kind, **more)
    return gltf, gltf.mesh(positions, material=gltf.material((0.9, 0.6, 0.3, 1)), attributes=accessors)


@case("gltf/plain", quick=True)
def gltf_plain(folder):
    gltf, mesh = gltf_solid()
    gltf.node(mesh=mesh, translation=(3, 1, 0), rotation=(0, math.sin(0.2), 0, math.cos(0.2)), scale=(1, 2, 1))
    return gltf.write(folder / "a.gltf")


@case("gltf/glb")
def gltf_binary(folder):
    gltf = gltf_square()
    view = gltf.view(png(paint()))
    gltf.document["images"] = [{"bufferView": view, "mimeType": "image/png"}]
    return gltf.write(folder / "a.glb")


@case("gltf/mirrored_node", quick=True)
def gltf_mirrored(folder):
    gltf, mesh = gltf_solid()
    child = gltf.node(root=False, mesh=mesh, translation=(0.5, 0, 0))
    gltf.node(children=[child], scale=(-1, 1, 1))
    return gltf.write(folder / "a.gltf")


@case("gltf/strip")
def gltf_strip(folder):
    gltf = Gltf()
    gltf.node(mesh=gltf.mesh(STRIP, mode=5))
    return gltf.write(folder / "a.gltf")


@case("gltf/without_normals")
def gltf_without_normals(folder):
    """Two facets at a blunt angle: without normals a glTF file has flat ones, by the specification."""
    gltf = Gltf()
    gltf.node(mesh=gltf.mesh([(0, 0, 0), (1, 0, 0.4), (1, 1, 0.4), (2, 0.2, 0)], (0, 1, 2, 1, 3, 2)))
    return gltf.write(folder / "a.gltf")


@case("gltf/fan")
def gltf_fan(folder):
    gltf = Gltf()
    rim = [(math.cos(a) * (1 + 0.2 * a), math.sin(a), 0) for a in numpy.linspace(0, 4.5, 9)]
    gltf.node(mesh=gltf.mesh([(0, 0, 0), *rim], range(10), mode=6))
    return gltf.write(folder / "a.gltf")


def bar(count=8):
    """A bar of `count` segments along y, 2 high: positions, indices, and how far up each vertex is, 0 to 1."""
    rings = [(x * (1 - 0.4 * t), 2 * t, z) for t in numpy.linspace(0, 1, count + 1)
             for x, z in ((-0.3, -0.1), (0.3, -0.1), (0.3, 0.1), (-0.3, 0.1))]
    faces = []
    for ring in range(0, 4 * count, 4):
        for side in range(4):
            a, b = ring + side, ring + (side + 1) % 4
            faces += [a, a + 4, b, b, a + 4, b + 4]
    return numpy.array(rings), faces, numpy.repeat(numpy.linspace(0, 1, count + 1), 4)


@case("gltf/skin", quick=True)
def gltf_skin(folder):
    gltf = Gltf()
    points, faces, height = bar()
    upper = numpy.clip(2 * height - 0.5, 0, 1)
    joints = gltf.accessor([(0, 1, 0, 0)] * len(points), "uint8")
    weights = gltf.accessor([(1 - w, w, 0, 0) for w in upper])
    mesh = gltf.mesh(points, faces, attributes={"JOINTS_0": joints, "WEIGHTS_0": weights})
    upwards = numpy.eye(4)
    upwards[3, 1] = -1  # column by column, as glTF has it
    inverse = gltf.accessor([numpy.eye(4), upwards])
    bent = (0, 0, math.sin(0.5), math.cos(0.5))
    tip = gltf.node(root=False, translation=(0, 1, 0), rotation=bent)
    base = gltf.node(children=[tip], rotation=(math.sin(0.2), 0, 0, math.cos(0.2)))
    gltf.document["skins"] = [{"joints": [base, tip], "inverseBindMatrices": inverse}]
    # A skinned mesh is where its joints are, not where its node is.
    gltf.node(mesh=mesh, skin=0, translation=(5, 0, 0), scale=(3, 1, 1))
    return gltf.write(folder / "a.gltf")


MIXED = ((1, 0.2, 0.1, 1), (0.2, 0.8, 0, 1), (0.1, 0.3, 0.9, 1), (0.5, 0.5, 0.5, 1))


@case("gltf/color_float", quick=True)
def gltf_color_float(folder):
    gltf, mesh = gltf_solid(COLOR_0=([color[:3] for color in MIXED], "float32"))
    gltf.node(mesh=mesh)
    return gltf.write(folder / "a.gltf")


@case("gltf/color_ubyte")
def gltf_color_ubyte(folder):
    gltf, mesh = gltf_solid(COLOR_0=(numpy.multiply(MIXED, 255), "uint8"))
    gltf.node(mesh=mesh)
    return gltf.write(folder / "a.gltf")


@case("gltf/color_ushort")
def gltf_color_ushort(folder):
    gltf, mesh = gltf_solid(COLOR_0=(numpy.multiply(MIXED, 65535), "uint16"))
    gltf.node(mesh=mesh)
    return gltf.write(folder / "a.gltf")


@case("gltf/color_times_texture")
def gltf_color_times_texture(folder):
    gltf = gltf_square(color=(1, 0.7, 0.7, 1))
    gltf.document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = gltf.accessor([color[:3] for color in MIXED])
    return gltf.write(folder / "a.gltf")


@case("gltf/texture", quick=True)
def gltf_texture(folder):
    return gltf_square().write(folder / "a.gltf")


@case("gltf/texture_transform", quick=True)
def gltf_transform(folder):
    turned = {"offset": [0.2, 0.35], "rotation": 0.6, "scale": [1.5, 0.8]}
    gltf = gltf_square(texture={"extensions": {"KHR_texture_transform": turned}})
    gltf.document["extensionsUsed"] = ["KHR_texture_transform"]
    return gltf.write(folder / "a.gltf")


@case("gltf/second_coordinates")
def gltf_second(folder):
    gltf = gltf_square(texture={"texCoord": 1})
    other = gltf.accessor([(v, 0.5 * u) for u, v in SQUARE_UV])
    gltf.document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = other
    return gltf.write(folder / "a.gltf")


@case("gltf/coordinates_ubyte", quick=True)
def gltf_coordinates_ubyte(folder):
    uv = numpy.multiply(SQUARE_UV, 255)
    return gltf_square(coordinates=uv, kind="uint8", normalized=True).write(folder / "a.gltf")


@case("gltf/coordinates_ushort")
def gltf_coordinates_ushort(folder):
    uv = numpy.multiply(SQUARE_UV, 65535)
    return gltf_square(coordinates=uv, kind="uint16", normalized=True).write(folder / "a.gltf")


REPEAT, CLAMP, MIRROR = 10497, 33071, 33648
BEYOND = [(2.4 * u - 0.7, 2.6 * v - 0.9) for u, v in SQUARE_UV]


@case("gltf/wrap_repeat")
def gltf_repeat(folder):
    return gltf_square(coordinates=BEYOND).write(folder / "a.gltf")


@case("gltf/wrap_clamp", quick=True)
def gltf_clamp(folder):
    return gltf_square(coordinates=BEYOND, sampler={"wrapS": CLAMP, "wrapT": CLAMP}).write(folder / "a.gltf")


@case("gltf/wrap_mirror")
def gltf_mirror(folder):
    return gltf_square(coordinates=BEYOND, sampler={"wrapS": MIRROR, "wrapT": MIRROR}).write(folder / "a.gltf")


@case("gltf/wrap_mixed")
def gltf_wrap_mixed(folder):
    return gltf_square(coordinates=BEYOND, sampler={"wrapS": CLAMP, "wrapT": MIRROR}).write(folder / "a.gltf")


@case("gltf/alpha_mask", quick=True)
def gltf_mask(folder):
    return gltf_square(paint_holes(), alphaMode="MASK", alphaCutoff=0.6).write(folder / "a.gltf")


@case("gltf/alpha_mask_low")
def gltf_mask_low(folder):
    """With 100 of 255 above the cutoff."""
    return gltf_square(paint_holes(), alphaMode="MASK", alphaCutoff=0.3).write(folder / "a.gltf")


@case("gltf/alpha_opaque", quick=True)
def gltf_opaque(folder):
    """The file says that alpha does not count."""
    return gltf_square(paint_holes()).write(folder / "a.gltf")


@case("gltf/alpha_blend", note="what is partly transparent is drawn opaque, on both sides")
def gltf_blend(folder):
    return gltf_square(paint_holes(), alphaMode="BLEND").write(folder / "a.gltf")


@case("gltf/alpha_of_color")
def gltf_alpha_of_color(folder):
    """A second square that isn't there."""
    gltf = gltf_square()
    hidden = gltf.material((1, 1, 1, 0), alphaMode="MASK")
    gltf.node(mesh=gltf.mesh(SQUARE, numpy.ravel(SQUARE_FACES), material=hidden), translation=(0.7, 0.3, 0.2))
    gltf.node(mesh=gltf.mesh(CORNERS, numpy.ravel(FACES)), translation=(0, 0, -1))
    return gltf.write(folder / "a.gltf")


@case("gltf/instancing", quick=True)
def gltf_instancing(folder):
    gltf, mesh = gltf_solid()
    places = gltf.accessor([(0, 0, 0), (2, 0.5, 0), (0.5, 2, -1)])
    turns = gltf.accessor([(0, 0, 0, 1), (0, 0, math.sin(0.4), math.cos(0.4)), (0, math.sin(1), 0, math.cos(1))])
    sizes = gltf.accessor([(1, 1, 1), (0.5, 1, 1), (1.3, 1.3, 1.3)])
    attributes = {"TRANSLATION": places, "ROTATION": turns, "SCALE": sizes}
    gltf.node(mesh=mesh, rotation=(0, math.sin(0.1), 0, math.cos(0.1)),
              extensions={"EXT_mesh_gpu_instancing": {"attributes": attributes}})
    gltf.require("EXT_mesh_gpu_instancing")
    return gltf.write(folder / "a.gltf")


@case("gltf/sparse", quick=True)
def gltf_sparse(folder):
    """Half of the corners are where the sparse values are."""
    gltf = Gltf()
    moved = numpy.array(CORNERS, "float32")
    moved[[1, 3]] = 0.1
    positions = gltf.accessor(moved)
    accessor = gltf.document["accessors"][positions]
    accessor["min"], accessor["max"] = CORNERS.min(0).tolist(), CORNERS.max(0).tolist()
    accessor["sparse"] = {"count": 2,
                          "indices": {"bufferView": gltf.view(numpy.array([1, 3], "uint16").tobytes()),
                                      "componentType": 5123},
                          "values": {"bufferView": gltf.view(numpy.array(CORNERS[[1, 3]], "float32").tobytes())}}
    gltf.node(mesh=gltf.mesh(positions, numpy.ravel(FACES)))
    return gltf.write(folder / "a.gltf")


@case("gltf/sparse_alone")
def gltf_sparse_alone(folder):
    """No buffer view: what the sparse values don't say is 0."""
    gltf = Gltf()
    positions = gltf.accessor(CORNERS)
    accessor = gltf.document["accessors"][positions]
    del accessor["bufferView"]
    accessor["sparse"] = {"count": 3,
                          "indices": {"bufferView": gltf.view(numpy.array([1, 2, 3], "uint8").tobytes()),
                                      "componentType": 5121},
                          "values": {"bufferView": gltf.view(numpy.array(CORNERS[1:], "float32").tobytes())}}
    gltf.node(mesh=gltf.mesh(positions, numpy.ravel(FACES)))
    return gltf.write(folder / "a.gltf")


def gltf_quantized(kind, normalized):
    gltf = Gltf()
    points, normals = separate_faces()
    largest = numpy.iinfo(kind).max
    positions = gltf.accessor(numpy.round(points / 1.5 * largest), kind, **({"normalized": True} if normalized else {}))
    normals = gltf.accessor(numpy.round(numpy.multiply(normals, 127)), "int8", normalized=True)
    scale = 1.5 if normalized else 1.5 / largest
    gltf.node(mesh=gltf.mesh(positions, attributes={"NORMAL": normals}), scale=(scale, scale, scale), translation=(1, 2, 3))
    gltf.require("KHR_mesh_quantization")
    return gltf


@case("gltf/quantized_short", quick=True)
def gltf_quantized_short(folder):
    return gltf_quantized("int16", True).write(folder / "a.gltf")


@case("gltf/quantized_byte")
def gltf_quantized_byte(folder):
    return gltf_quantized("int8", False).write(folder / "a.gltf")


@case("gltf/quantized_ushort")
def gltf_quantized_ushort(folder):
    return gltf_quantized("uint16", False).write(folder / "a.gltf")


@case("gltf/percent_encoded")
def gltf_percent(folder):
    gltf = gltf_square()
    gltf.document["images"] = [{"uri": "my%20picture.png"}]
    (folder / "my picture.png").write_bytes(png(paint()))
    return gltf.write(folder / "a.gltf")


@case("gltf/missing_texture", note="the colour, without the texture")
def gltf_missing(folder):
    gltf = gltf_square(color=(0.8, 0.5, 0.2, 1))
    gltf.document["images"] = [{"uri": "nowhere.png"}]
    return gltf.write(folder / "a.gltf")


@case("gltf/meshopt_required", message="EXT_meshopt_compression")
def gltf_meshopt(folder):
    gltf, mesh = gltf_solid()
    gltf.node(mesh=mesh)
    for view in gltf.document["bufferViews"]:
        view["extensions"] = {"EXT_meshopt_compression": {"buffer": 0, "byteLength": view["byteLength"], "byteStride": 12,
                                                          "count": 12, "mode": "ATTRIBUTES"}}
        view["buffer"] = 1  # which has no bytes
    gltf.require("EXT_meshopt_compression")
    file = gltf.write(folder / "a.gltf")
    gltf.document["buffers"].append({"byteLength": len(gltf.blob)})
    file.write_text(json.dumps(gltf.document), encoding="utf-8")
    return file


@case("usd/ascii", message="USD")
def usd_ascii(folder):
    file = folder / "a.usda"
    file.write_text("""#usda 1.0
def Mesh "a"
{
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
}
""", encoding="utf-8")
    return file


# --- OBJ

SOLID_OBJ = "".join(f"v {row}\n" for row in words(CORNERS).splitlines()) \
    + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in FACES)
SQUARE_OBJ = "mtllib a.mtl\n" + "".join(f"v {row}\n" for row in words(SQUARE).splitlines()) \
    + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl shown\nf 1/1 2/2 3/3 4/4\n"


def write_obj(folder, text, library=None, **pictures):
    """`pictures` maps names, without their .png, to images."""
    (folder / "a.obj").write_text(text, encoding="utf-8")
    if library is not None:
        (folder / "a.mtl").write_text(library, encoding="utf-8")
    for name, image in pictures.items():
        image.save(folder / f"{name}.png")
    return folder / "a.obj"


@case("obj/plain", quick=True)
def obj_plain(folder):
    return write_obj(folder, SOLID_OBJ)


@case("obj/kd", note="three.js takes Kd for sRGB; as light, which we take it for, it is compared")
def obj_kd(folder):
    return write_obj(folder, SQUARE_OBJ, "newmtl shown\nKd 0.6 0.3 0.1\n")


@case("obj/map_kd", quick=True)
def obj_map(folder):
    return write_obj(folder, SQUARE_OBJ, "newmtl shown\nKd 1 1 1\nmap_Kd paint.png\n", paint=paint())


@case("obj/map_kd_offset_scale", quick=True)
def obj_map_moved(folder):
    library = "newmtl shown\nKd 1 1 1\nmap_Kd -s 2 0.7 1 -o 0.3 0.15 0 paint.png\n"
    return write_obj(folder, SQUARE_OBJ, library, paint=paint())


TWO_SQUARES_OBJ = SQUARE_OBJ + "".join(f"v {x + 0.5:g} {y + 0.4:g} 0.3\n" for x, y, _ in SQUARE) \
    + "usemtl other\nf 5/1 6/2 7/3 8/4\n"


@case("obj/d_zero", quick=True)
def obj_d_zero(folder):
    return write_obj(folder, TWO_SQUARES_OBJ, "newmtl shown\nKd 1 0 0\nnewmtl other\nKd 0 1 0\nd 0\n")


@case("obj/map_kd_alpha", known=True, note="we cut the texture's alpha of 0 out; three.js does only with a map_d")
def obj_map_alpha(folder):
    return write_obj(folder, SQUARE_OBJ, "newmtl shown\nKd 1 1 1\nmap_Kd holes.png\n", holes=paint_holes())


@case("obj/map_d")
def obj_map_d(folder):
    library = "newmtl shown\nKd 1 0 0\nnewmtl other\nKd 1 1 1\nmap_Kd paint.png\nmap_d holes.png\n"
    holes = paint_holes().getchannel("A").point(lambda alpha: 255 * (alpha > 0))
    return write_obj(folder, TWO_SQUARES_OBJ, library, paint=paint(), holes=holes)


@case("obj/vertex_colors", quick=True)
def obj_colors(folder):
    rows = [(*corner, *color) for corner, color in zip(CORNERS, PURE)]
    text = "".join(f"v {row}\n" for row in words(rows).splitlines())
    return write_obj(folder, text + SOLID_OBJ[SOLID_OBJ.index("f "):])


@case("obj/w")
def obj_w(folder):
    return write_obj(folder, SOLID_OBJ.replace("v 1.5 0 0\n", "v 1.5 0 0 0.5\n").replace("v 0 1 0\n", "v 0 1 0 2\n"))


@case("obj/leading_dot", quick=True)
def obj_leading_dot(folder):
    text = SOLID_OBJ.replace("v 0 0 0.6", "v 0 -.1 .6").replace("v 1.5 0 0", "v 1.5 .0 -.25")
    return write_obj(folder, text)


@case("obj/exponents")
def obj_exponents(folder):
    return write_obj(folder, SOLID_OBJ.replace("v 1.5 0 0", "v 15e-1 0 1.E-3").replace("v 0 0 0.6", "v +0 0 6.0E-01"))


@case("obj/negative_indices")
def obj_negative(folder):
    text = "".join(f"v {row}\n" for row in words(CORNERS).splitlines())
    return write_obj(folder, text + "".join(f"f {a - 4} {b - 4} {c - 4}\n" for a, b, c in FACES))


@case("obj/unknown_keys", quick=True)
def obj_unknown(folder):
    library = "newmtl shown\naniso 0.4\nanisor 0.2\nPr 0.5\nfoo bar 1\nmap_foo -x 1 paint.png\nKd 1 0 1\n"
    return write_obj(folder, SQUARE_OBJ.replace("usemtl", "vendor_key 3 4\nusemtl"), library)


@case("obj/indices_without_vt", note="three.js, without coordinates, shows the texture's first texel: plain here")
def obj_without_vt(folder):
    text = SOLID_OBJ[:SOLID_OBJ.index("f ")] + "vn 0 0 1\nmtllib a.mtl\nusemtl shown\n" \
        + "".join(f"f {a + 1}/{a + 1}/1 {b + 1}/{b + 1}/1 {c + 1}/{c + 1}/1\n" for a, b, c in FACES)
    return write_obj(folder, text, "newmtl shown\nKd 1 0 0\n")


@case("obj/continued_lines")
def obj_continued(folder):
    return write_obj(folder, SQUARE_OBJ.replace("f 1/1 2/2 3/3", "f 1/1 2/2 \\\n3/3"), "newmtl shown\nKd 1 0 0\n")


@case("obj/groups_and_windows_line_ends")
def obj_groups(folder):
    text = "o first\ng a b\ns 1\n" + SOLID_OBJ + "o second\ng c\ns off\nv 2 2 0\nv 3 2 0\nv 2 3 0.5\nf 5 6 7\n"
    (folder / "a.obj").write_bytes(text.replace("\n", "\r\n").encode())
    return folder / "a.obj"


@case("obj/missing_mtl", note="Assimp's grey")
def obj_missing_mtl(folder):
    return write_obj(folder, SQUARE_OBJ)


@case("obj/missing_texture", note="the colour, without the texture")
def obj_missing_texture(folder):
    return write_obj(folder, SQUARE_OBJ, "newmtl shown\nKd 0 0.5 1\nmap_Kd nowhere.png\n")


@case("obj/letter_case", note="three.js reads the names as they are on the disk")
def obj_letter_case(folder):
    theirs = folder / "theirs"
    theirs.mkdir()
    write_obj(theirs, SQUARE_OBJ, "newmtl shown\nKd 1 1 1\nmap_Kd paint.png\n", paint=paint())
    return write_obj(folder, SQUARE_OBJ, "newmtl shown\nKd 1 1 1\nmap_Kd Paint.PNG\n", paint=paint()), theirs / "a.obj"


@case("obj/texture_beside_mtl", quick=True)
def obj_beside_mtl(folder):
    (folder / "materials" / "images").mkdir(parents=True)
    paint().save(folder / "materials" / "images" / "paint.png")
    library = "newmtl shown\nKd 1 1 1\nmap_Kd images/paint.png\n"
    (folder / "materials" / "a.mtl").write_text(library, encoding="utf-8")
    return write_obj(folder, SQUARE_OBJ.replace("a.mtl", "materials/a.mtl"))


# --- PLY

PLY_HEAD = "ply\nformat {} 1.0\ncomment made for a test\nelement vertex 4\nproperty float x\nproperty float y\n" \
           "property float z\n{}element face 4\nproperty list uchar int vertex_indices\nend_header\n"
PLY_COLORS = "property uchar red\nproperty uchar green\nproperty uchar blue\n"


def write_ply(folder, text, body=b""):
    (folder / "a.ply").write_bytes(text.encode() + body)
    return folder / "a.ply"


def ply_faces(order):
    return b"".join(struct.pack(order + "B3i", 3, *face) for face in FACES)


@case("ply/ascii", quick=True)
def ply_ascii(folder):
    return write_ply(folder, PLY_HEAD.format("ascii", "") + words(CORNERS) + words((3, *face) for face in FACES))


@case("ply/ascii_colors", quick=True)
def ply_ascii_colors(folder):
    rows = [(*corner, *(255 * c for c in color)) for corner, color in zip(CORNERS, PURE)]
    return write_ply(folder, PLY_HEAD.format("ascii", PLY_COLORS) + words(rows) + words((3, *face) for face in FACES))


@case("ply/float_colors")
def ply_float_colors(folder):
    head = PLY_HEAD.format("ascii", PLY_COLORS.replace("uchar", "float"))
    rows = [(*corner, *color) for corner, color in zip(CORNERS, PURE)]
    return write_ply(folder, head + words(rows) + words((3, *face) for face in FACES))


@case("ply/little_endian_colors")
def ply_little(folder):
    vertices = b"".join(struct.pack("<3f3B", *corner, *(255 * c for c in color)) for corner, color in zip(CORNERS, PURE))
    return write_ply(folder, PLY_HEAD.format("binary_little_endian", PLY_COLORS), vertices + ply_faces("<"))


@case("ply/big_endian")
def ply_big(folder):
    vertices = b"".join(struct.pack(">3f", *corner) for corner in CORNERS)
    return write_ply(folder, PLY_HEAD.format("binary_big_endian", ""), vertices + ply_faces(">"))


@case("ply/squares_and_unknown_elements")
def ply_squares(folder):
    head = PLY_HEAD.format("ascii", "property float quality\n").replace("face 4", "face 1")
    head = head.replace("end_header", "element extra 1\nproperty int mark\nend_header")
    return write_ply(folder, head + words((*corner, 0.5) for corner in SQUARE) + "4 0 1 2 3\n7\n")


@case("ply/strips", note="three.js has no strips: it reads the same triangles as single faces")
def ply_strips(folder):
    head = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
    strip = head + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + words(STRIP)
    faces = head + "element face 3\nproperty list uchar int vertex_indices\nend_header\n" + words(STRIP)
    theirs = folder / "b.ply"
    theirs.write_text(faces + "3 0 1 2\n3 2 1 3\n3 3 4 5\n", encoding="utf-8")
    return write_ply(folder, strip + "8 0 1 2 3 -1 3 4 5\n"), theirs


# --- STL

def stl_ascii(name):
    text = f"solid {name}\n"
    for normal, face in zip(facet_normals(), FACES):
        text += "facet normal " + words([normal]) + "outer loop\n" \
            + "".join("vertex " + words([CORNERS[i]]) for i in face) + "endloop\nendfacet\n"
    return text + f"endsolid {name}\n"


def stl_binary(header):
    triangles = b"".join(struct.pack("<12fH", *normal, *numpy.ravel(CORNERS[list(face)]), 0)
                         for normal, face in zip(facet_normals(), FACES))
    return header.ljust(80, b"\0") + struct.pack("<I", len(FACES)) + triangles


@case("stl/ascii", quick=True)
def stl_words(folder):
    (folder / "a.stl").write_text(stl_ascii("a name"), encoding="utf-8")
    return folder / "a.stl"


@case("stl/binary")
def stl_bytes(folder):
    (folder / "a.stl").write_bytes(stl_binary(b"made for a test"))
    return folder / "a.stl"


@case("stl/binary_called_solid")
def stl_called_solid(folder):
    (folder / "a.stl").write_bytes(stl_binary(b"solid but binary"))
    return folder / "a.stl"


@case("stl/empty_solid")
def stl_empty(folder):
    (folder / "a.stl").write_text(stl_ascii("first") + "solid second\nendsolid second\n", encoding="utf-8")
    return folder / "a.stl"


# --- FBX, in words: a mesh of one model, with what a case adds

def write_fbx(folder, points, faces, *, up=1, layers="", model="", objects="", connections="", colors=""):
    front, sign = (2, 1) if up == 1 else (1, -1)
    polygons = ",".join(f"{a},{b},{~c}" for a, b, c in faces)
    numbers = ",".join(f"{value:g}" for value in numpy.ravel(points))
    text = f"""; FBX 7.4.0 project file
FBXHeaderExtension:  {{
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}}
GlobalSettings:  {{
	Version: 1000
	Properties70:  {{
		P: "UpAxis", "int", "Integer", "",{up}
		P: "UpAxisSign", "int", "Integer", "",1
		P: "FrontAxis", "int", "Integer", "",{front}
		P: "FrontAxisSign", "int", "Integer", "",{sign}
		P: "CoordAxis", "int", "Integer", "",0
		P: "CoordAxisSign", "int", "Integer", "",1
		P: "OriginalUpAxis", "int", "Integer", "",{up}
		P: "OriginalUpAxisSign", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",1
	}}
}}
Objects:  {{
	Geometry: 1000, "Geometry::a", "Mesh" {{
		Vertices: *{3 * len(points)} {{
			a: {numbers}
		}}
		PolygonVertexIndex: *{3 * len(faces)} {{
			a: {polygons}
		}}
		GeometryVersion: 124
{layers}
		Layer: 0 {{
			Version: 100
{colors}
		}}
	}}
	Model: 2000, "Model::a", "Mesh" {{
		Version: 232
		Properties70:  {{
{model}
		}}
		Shading: T
		Culling: "CullingOff"
	}}
{objects}
}}
Connections:  {{
	C: "OO",2000,0
	C: "OO",1000,2000
{connections}
}}
"""
    (folder / "a.fbx").write_text(text, encoding="utf-8")
    return folder / "a.fbx"


@case("fbx/y_up", quick=True)
def fbx_y_up(folder):
    model = '\t\t\tP: "Lcl Translation", "Lcl Translation", "", "A",2,1,0\n' \
            '\t\t\tP: "Lcl Rotation", "Lcl Rotation", "", "A",0,20,30'
    return write_fbx(folder, CORNERS, FACES, model=model)


@case("fbx/z_up", quick=True)
def fbx_z_up(folder):
    return write_fbx(folder, CORNERS, FACES, up=2)


@case("fbx/vertex_colors")
def fbx_colors(folder):
    numbers = ",".join(f"{value:g}" for color in PURE for value in (*color, 1))
    indices = ",".join(str(i) for face in FACES for i in face)
    layer = f"""		LayerElementColor: 0 {{
			Version: 101
			Name: "colors"
			MappingInformationType: "ByPolygonVertex"
			ReferenceInformationType: "IndexToDirect"
			Colors: *16 {{
				a: {numbers}
			}}
			ColorIndex: *12 {{
				a: {indices}
			}}
		}}"""
    use = '\t\t\tLayerElement:  {\n\t\t\t\tType: "LayerElementColor"\n\t\t\t\tTypedIndex: 0\n\t\t\t}'
    return write_fbx(folder, CORNERS, FACES, layers=layer, colors=use)


def write_fbx_square(folder, wrap):
    """`wrap` is that of u: 0 repeats, 1 clamps."""
    paint().save(folder / "paint.png")
    coordinates = ",".join(f"{value:g}" for u, v in SQUARE_UV for value in (2 * u - 0.5, 1.5 - 2 * v))
    layer = f"""		LayerElementUV: 0 {{
			Version: 101
			Name: "map"
			MappingInformationType: "ByVertice"
			ReferenceInformationType: "Direct"
			UV: *8 {{
				a: {coordinates}
			}}
		}}
		LayerElementMaterial: 0 {{
			Version: 101
			Name: ""
			MappingInformationType: "AllSame"
			ReferenceInformationType: "IndexToDirect"
			Materials: *1 {{
				a: 0
			}}
		}}"""
    use = "".join(f'\t\t\tLayerElement:  {{\n\t\t\t\tType: "{kind}"\n\t\t\t\tTypedIndex: 0\n\t\t\t}}\n'
                  for kind in ("LayerElementUV", "LayerElementMaterial"))
    objects = f"""	Material: 6000, "Material::shown", "" {{
		Version: 102
		ShadingModel: "lambert"
		Properties70:  {{
			P: "DiffuseColor", "Color", "", "A",1,1,1
			P: "DiffuseFactor", "Number", "", "A",1
		}}
	}}
	Video: 6002, "Video::paint", "Clip" {{
		Type: "Clip"
		Filename: "paint.png"
		RelativeFilename: "paint.png"
	}}
	Texture: 6001, "Texture::paint", "" {{
		Type: "TextureVideoClip"
		Version: 202
		TextureName: "Texture::paint"
		Media: "Video::paint"
		FileName: "paint.png"
		RelativeFilename: "paint.png"
		Properties70:  {{
			P: "WrapModeU", "enum", "", "",{wrap}
			P: "WrapModeV", "enum", "", "",0
		}}
	}}
"""
    connections = '\tC: "OO",6000,2000\n\tC: "OP",6001,6000, "DiffuseColor"\n\tC: "OO",6002,6001\n'
    return write_fbx(folder, SQUARE, SQUARE_FACES, layers=layer, colors=use, objects=objects, connections=connections)


@case("fbx/texture", quick=True)
def fbx_texture(folder):
    return write_fbx_square(folder, 0)


@case("fbx/wrap_clamp")
def fbx_clamp(folder):
    return write_fbx_square(folder, 1)


def matrix_words(matrix):
    """Column by column."""
    return ",".join(f"{value:g}" for value in numpy.asarray(matrix).T.ravel())


def turned_about_z(angle):
    matrix = numpy.eye(4)
    matrix[:2, :2] = [[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]]
    return matrix


def moved(x, y, z):
    matrix = numpy.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


@case("fbx/skin", quick=True)
def fbx_skin(folder):
    points, flat, height = bar()
    faces = numpy.reshape(flat, (-1, 3))
    upper = numpy.clip(2 * height - 0.5, 0, 1)
    clusters, models, connections = "", "", '\tC: "OO",3000,1000\n'
    bones = ((4000, 5000, 1 - upper, moved(0, 0, 0), "0,0,0", "0,0,10", 0),
             (4001, 5001, upper, moved(0, 1, 0), "0,1,0", "0,0,50", 5000))
    for cluster, bone, weights, bind, place, turn, parent in bones:
        used = numpy.flatnonzero(weights)
        clusters += f"""	Deformer: {cluster}, "SubDeformer::{bone}", "Cluster" {{
		Version: 100
		UserData: "", ""
		Indexes: *{len(used)} {{
			a: {",".join(map(str, used))}
		}}
		Weights: *{len(used)} {{
			a: {",".join(f"{w:g}" for w in weights[used])}
		}}
		Transform: *16 {{
			a: {matrix_words(numpy.linalg.inv(bind))}
		}}
		TransformLink: *16 {{
			a: {matrix_words(bind)}
		}}
	}}
"""
        models += f"""	Model: {bone}, "Model::bone{bone}", "LimbNode" {{
		Version: 232
		Properties70:  {{
			P: "Lcl Translation", "Lcl Translation", "", "A",{place}
			P: "Lcl Rotation", "Lcl Rotation", "", "A",{turn}
		}}
	}}
"""
        connections += f'\tC: "OO",{cluster},3000\n\tC: "OO",{bone},{cluster}\n\tC: "OO",{bone},{parent}\n'
    skin = '\tDeformer: 3000, "Deformer::", "Skin" {\n\t\tVersion: 101\n\t\tLink_DeformAcuracy: 50\n\t}\n'
    return write_fbx(folder, points, faces, objects=models + skin + clusters, connections=connections)


# --- Collada

def write_collada(folder, points, faces, *, up="Y_UP", unit=1, node="", controllers="", instance=None, nodes="",
                  effects=""):
    points = numpy.asarray(points)
    numbers = " ".join(f"{value:g}" for value in points.ravel())
    instance = instance or '<instance_geometry url="#mesh"/>'
    text = f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="unit" meter="{unit}"/><up_axis>{up}</up_axis></asset>
  {effects}
  <library_geometries><geometry id="mesh" name="mesh"><mesh>
    <source id="positions"><float_array id="values" count="{points.size}">{numbers}</float_array>
      <technique_common><accessor source="#values" count="{len(points)}" stride="3"><param name="X" type="float"/>
      <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
    <vertices id="vertices"><input semantic="POSITION" source="#positions"/></vertices>
    <triangles count="{len(faces)}"><input semantic="VERTEX" source="#vertices" offset="0"/>
      <p>{" ".join(str(i) for face in faces for i in face)}</p></triangles>
  </mesh></geometry></library_geometries>
  {controllers}
  <library_visual_scenes><visual_scene id="scene" name="scene">
    {nodes}
    <node id="shown" name="shown">{node}{instance}</node>
  </visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
"""
    (folder / "a.dae").write_text(text, encoding="utf-8")
    return folder / "a.dae"


@case("dae/y_up", quick=True)
def dae_y_up(folder):
    node = "<translate>1 2 0</translate><rotate>0 0 1 25</rotate><scale>1 1.5 1</scale>"
    return write_collada(folder, CORNERS, FACES, node=node)


@case("dae/z_up")
def dae_z_up(folder):
    return write_collada(folder, CORNERS, FACES, up="Z_UP")


@case("dae/x_up", known=True, note="three.js leaves such a file lying")
def dae_x_up(folder):
    return write_collada(folder, CORNERS, FACES, up="X_UP")


@case("dae/centimetres")
def dae_centimetres(folder):
    return write_collada(folder, CORNERS, FACES, unit=0.01)


def collada_floats(name, values, stride, parameter, kind="float"):
    values = list(values)
    listed = "Name" if kind == "name" else "float"
    type_of_each = "float4x4" if stride == 16 else kind
    return f'<source id="{name}"><{listed}_array id="{name}-values" count="{len(values)}">' \
           f'{" ".join(v if kind == "name" else f"{v:g}" for v in values)}</{listed}_array><technique_common>' \
           f'<accessor source="#{name}-values" count="{len(values) // stride}" stride="{stride}">' \
           f'<param name="{parameter}" type="{type_of_each}"/></accessor></technique_common></source>'


@case("dae/skin", quick=True)
def dae_skin(folder):
    points, flat, height = bar()
    upper = numpy.clip(2 * height - 0.5, 0, 1)
    inverse = [*numpy.eye(4).ravel(), *moved(0, -1, 0).ravel()]
    weights = [value for w in upper for value in (1 - w, w)]
    pairs = " ".join(f"0 {2 * i} 1 {2 * i + 1}" for i in range(len(points)))
    controllers = f"""<library_controllers><controller id="skin"><skin source="#mesh">
      <bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>
      {collada_floats("joints", ["base", "tip"], 1, "JOINT", "name")}
      {collada_floats("inverse", inverse, 16, "TRANSFORM")}
      {collada_floats("weights", weights, 1, "WEIGHT")}
      <joints><input semantic="JOINT" source="#joints"/><input semantic="INV_BIND_MATRIX" source="#inverse"/></joints>
      <vertex_weights count="{len(points)}"><input semantic="JOINT" source="#joints" offset="0"/>
        <input semantic="WEIGHT" source="#weights" offset="1"/>
        <vcount>{"2 " * len(points)}</vcount><v>{pairs}</v></vertex_weights>
    </skin></controller></library_controllers>"""
    nodes = """<node id="base-node" name="base" sid="base" type="JOINT"><rotate sid="turn">0 0 1 10</rotate>
      <node id="tip-node" name="tip" sid="tip" type="JOINT"><translate>0 1 0</translate><rotate>0 0 1 50</rotate></node>
      </node>"""
    instance = '<instance_controller url="#skin"><skeleton>#base-node</skeleton></instance_controller>'
    return write_collada(folder, points, numpy.reshape(flat, (-1, 3)), controllers=controllers, nodes=nodes,
                         instance=instance)


# --- 3DS, AMF and 3MF

def chunk(kind, *parts):
    data = b"".join(parts)
    return struct.pack("<HI", kind, 6 + len(data)) + data


@case("3ds/plain", quick=True)
def max_3ds(folder):
    points, _ = separate_faces()
    vertices = struct.pack("<H", 12) + b"".join(struct.pack("<3f", *point) for point in points)
    faces = struct.pack("<H", 4) + b"".join(struct.pack("<4H", i, i + 1, i + 2, 7) for i in range(0, 12, 3)) \
        + chunk(0x4150, struct.pack("<4I", 1, 2, 4, 8))  # each is a group of its own
    mesh = chunk(0x4100, chunk(0x4110, vertices), chunk(0x4120, faces))
    file = folder / "a.3ds"
    file.write_bytes(chunk(0x4D4D, chunk(0x0002, struct.pack("<I", 3)), chunk(0x3D3D, chunk(0x4000, b"solid\0", mesh))))
    return file


@case("amf/without_colors")
def amf_without_colors(folder):
    file = amf_plain(folder)
    text = file.read_text(encoding="utf-8")
    file.write_text(re.sub(r"<material .*</material>| materialid=\"2\"", "", text), encoding="utf-8")
    return file


@case("amf/plain")
def amf_plain(folder):
    vertices = "".join("<vertex><coordinates><x>{:g}</x><y>{:g}</y><z>{:g}</z></coordinates></vertex>".format(*corner)
                       for corner in CORNERS)
    faces = "".join("<triangle><v1>{}</v1><v2>{}</v2><v3>{}</v3></triangle>".format(*face) for face in FACES)
    file = folder / "a.amf"
    file.write_text(f"""<?xml version="1.0" encoding="UTF-8"?>
<amf unit="millimeter"><material id="2"><color><r>1</r><g>0.4</g><b>0.2</b></color></material>
<object id="1"><mesh><vertices>{vertices}</vertices><volume materialid="2">{faces}</volume></mesh></object></amf>
""", encoding="utf-8")
    return file


@case("amf/two_volumes")
def amf_volumes(folder):
    vertices = "".join("<vertex><coordinates><x>{:g}</x><y>{:g}</y><z>{:g}</z></coordinates></vertex>".format(*corner)
                       for corner in CORNERS)
    volumes = "".join('<volume materialid="2"><triangle><v1>{}</v1><v2>{}</v2><v3>{}</v3></triangle></volume>'.format(*face)
                      for face in FACES[2:])
    file = folder / "a.amf"
    file.write_text(f"""<?xml version="1.0" encoding="UTF-8"?>
<amf unit="millimeter"><material id="2"><color><r>1</r><g>0.4</g><b>0.2</b></color></material>
<object id="1"><mesh><vertices>{vertices}</vertices>{volumes}</mesh></object></amf>
""", encoding="utf-8")
    return file


@case("3mf/plain")
def mf_plain(folder):
    vertices = "".join('<vertex x="{:g}" y="{:g}" z="{:g}"/>'.format(*corner) for corner in CORNERS)
    faces = "".join('<triangle v1="{}" v2="{}" v3="{}"/>'.format(*face) for face in FACES)
    model = f"""<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<resources><object id="1" type="model"><mesh><vertices>{vertices}</vertices><triangles>{faces}</triangles></mesh>
</object></resources>
<build><item objectid="1"/></build></model>"""
    relations = """<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>"""
    types = """<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>"""
    file = folder / "a.3mf"
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("[Content_Types].xml", types)
        archive.writestr("_rels/.rels", relations)
        archive.writestr("3D/3dmodel.model", model)
    return file
