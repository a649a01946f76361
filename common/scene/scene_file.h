// SPDX-License-Identifier: MIT
// Scenes in TOML, read with toml++. The format is described in docs/scene-format.md.
#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace stagelight {

// Images are at most this wide and high.
constexpr int largest_image_size = 16384;

// Reads a scene with its meshes and textures. Throws UserError
// "file:line:column: what is wrong, what was expected" at the first mistake: a file
// that can't be read, TOML syntax, an unknown key (with the nearest known one), a
// wrong type, a value out of its range, an unknown material, a texture on a plane.
Scene load_scene(const std::filesystem::path &file);

}  // namespace stagelight
