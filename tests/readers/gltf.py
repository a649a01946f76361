# SPDX-License-Identifier: MIT
"""Writes small glTF files."""
import base64
import json
import struct

import numpy

COMPONENTS = {"int8": 5120, "uint8": 5121, "int16": 5122, "uint16": 5123, "uint32": 5125, "float32": 5126}
TYPES = {(): "SCALAR", (2,): "VEC2", (3,): "VEC3", (4,): "VEC4", (4, 4): "MAT4"}


class Gltf:
    """`document` is the file's JSON, for whatever a case adds to it; a mesh, material or node is told by its index."""

    def __init__(self):
        self.document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                         "accessors": [], "bufferViews": [], "materials": []}
        self.blob = b""

    def view(self, data, **more):
        self.blob += b"\0" * (-len(self.blob) % 4)
        self.document["bufferViews"].append({"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data), **more})
        self.blob += data
        return len(self.document["bufferViews"]) - 1

    def accessor(self, values, kind="float32", **more):
        """Rows of types that don't fill multiples of 4 bytes are padded, as glTF wants them for vertices."""
        values = numpy.asarray(values, kind)
        rows = values.reshape(len(values), -1)
        stride = rows.shape[1] * values.itemsize
        described = {"componentType": COMPONENTS[kind], "count": len(values), "type": TYPES[values.shape[1:]], **more}
        if described["type"] == "VEC3":
            described |= {"min": rows.min(0).tolist(), "max": rows.max(0).tolist()}
        if values.ndim > 1 and stride % 4:
            padding = b"\0" * (-stride % 4)
            view = self.view(b"".join(row.tobytes() + padding for row in rows), byteStride=stride + len(padding))
        else:
            view = self.view(values.tobytes())
        self.document["accessors"].append({"bufferView": view, **described})
        return len(self.document["accessors"]) - 1

    def material(self, color=(1, 1, 1, 1), texture=None, **more):
        """`texture` is glTF's textureInfo."""
        described = {"baseColorFactor": list(color), "metallicFactor": 0, "roughnessFactor": 1}
        if texture is not None:
            described["baseColorTexture"] = texture
        self.document["materials"].append({"pbrMetallicRoughness": described, **more})
        return len(self.document["materials"]) - 1

    def picture(self, image, sampler=None):
        """A texture of its own; `image` is glTF's image, {"uri": …} or {"bufferView": …, "mimeType": …}."""
        self.document.setdefault("images", []).append(image)
        texture = {"source": len(self.document["images"]) - 1}
        if sampler is not None:
            self.document.setdefault("samplers", []).append(sampler)
            texture["sampler"] = len(self.document["samplers"]) - 1
        self.document.setdefault("textures", []).append(texture)
        return len(self.document["textures"]) - 1

    def mesh(self, positions, indices=None, *, material=None, mode=4, attributes=None):
        """`positions` is a list of points or an accessor; `attributes` are accessors by their glTF names."""
        if not isinstance(positions, int):
            positions = self.accessor(positions)
        primitive = {"attributes": {"POSITION": positions, **(attributes or {})}, "mode": mode}
        if indices is not None:
            primitive["indices"] = self.accessor(indices, "uint16")
        if material is not None:
            primitive["material"] = material
        self.document["meshes"].append({"primitives": [primitive]})
        return len(self.document["meshes"]) - 1

    def node(self, *, root=True, **described):
        self.document["nodes"].append(described)
        if root:
            self.document["scenes"][0]["nodes"].append(len(self.document["nodes"]) - 1)
        return len(self.document["nodes"]) - 1

    def require(self, extension):
        self.document.setdefault("extensionsUsed", []).append(extension)
        self.document.setdefault("extensionsRequired", []).append(extension)

    def write(self, file):
        """As .gltf with its buffer beside it, or as .glb."""
        if not self.document["materials"]:
            del self.document["materials"]
        self.blob += b"\0" * (-len(self.blob) % 4)
        buffer = {"byteLength": len(self.blob)}
        self.document["buffers"] = [buffer]
        if file.suffix == ".gltf":
            buffer["uri"] = file.stem + ".bin"
            file.with_suffix(".bin").write_bytes(self.blob)
            file.write_text(json.dumps(self.document), encoding="utf-8")
            return file
        text = json.dumps(self.document).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
        chunks += struct.pack("<II", len(self.blob), 0x004E4942) + self.blob
        file.write_bytes(struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks)
        return file


def data_uri(data, kind):
    return f"data:{kind};base64," + base64.b64encode(data).decode()
