// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace stagelight {

// How far a scene has come.
struct SceneSizes {
    explicit SceneSizes(const Scene &scene);
    std::size_t materials, vertices, triangles, textures;
};

// What a mesh file has brought to the scene since it was of these sizes, as bytes.
std::string part_since(const SceneSizes &before, const Scene &scene);

// Appends such a part to a scene of the sizes that it was made from. False if it is none: the
// reader it is from may have gone astray.
bool append_part(Scene &scene, std::string_view part, const SourceLocation &where);

// A texture as bytes, and back, if they are one.
std::string bytes_of(const Texture &texture);
std::optional<Texture> texture_of(std::string_view bytes);

}  // namespace stagelight
