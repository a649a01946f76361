// SPDX-License-Identifier: MIT
// What the fuzzers try, read as the program would read it: a UserError or a MachineError is an
// answer, anything else is a finding.
#pragma once

#include <string_view>

namespace stagelight::fuzz {

void read_scene(std::string_view bytes);
// The first byte says in which of mesh_formats the others are.
void read_mesh(std::string_view bytes);
void read_texture(std::string_view bytes);

// Extensions, and that of the materials of an OBJ; fuzz.sh makes its seeds from this list.
constexpr std::string_view mesh_formats[]{"obj",   "ply", "stl", "off", "gltf", "glb", "3ds",
                                          "blend", "dae", "fbx", "x",   "lwo",  "mtl"};

}  // namespace stagelight::fuzz
