// SPDX-License-Identifier: MIT
// Parts of a scene as bytes, which a sandbox can hand back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace stagelight {

// How far a scene has come.
struct SceneSizes {
    explicit SceneSizes(const Scene &scene);
    std::size_t materials, vertices, triangles, textures, warnings;
};

// What a mesh file has brought to the scene since it was of these sizes, as bytes.
std::string serialise_since(const SceneSizes &before, const Scene &scene);

// Appends those to a scene of the sizes that they were made from. False if they are none: the
// reader they are from may have gone astray.
bool append_serialised(Scene &scene, std::string_view bytes, const SourceLocation &where);

// A texture as bytes, and back, if they are one.
std::string serialise(const Texture &texture);
std::optional<Texture> deserialise_texture(std::string_view bytes);

}  // namespace stagelight
