// SPDX-License-Identifier: MIT
// glTF files, written so that Assimp's reader makes of them what the specification says.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "scene/mesh_notes.h"

namespace stagelight {

struct GltfInput {
    std::string bytes;      // instead of the file
    std::string converted;  // the file that it names `converted_buffer`
};

constexpr std::string_view converted_buffer = "stagelight-converted.bin";

// The bytes of a file that lies beside the glTF file; "" if there is none.
using ReadBeside = std::function<std::string(const std::string &name)>;

// Makes floats of integers in accessors, children of the instances of a node (of
// EXT_mesh_gpu_instancing), and a mesh of its own of each skin that wears one; names nodes and
// materials apart; takes WebP pictures for the texture's; drops animations. What is lost with it,
// and KHR_texture_transform, goes to `notes`. Nothing for a file that is no glTF 2.0: the reader
// will say why. Throws std::invalid_argument, with what was expected, for one that requires an
// extension without which no picture is right.
std::optional<GltfInput> prepared_gltf(std::string_view bytes, const ReadBeside &read_beside,
                                       MeshNotes &notes);

}  // namespace stagelight
