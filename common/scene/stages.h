// SPDX-License-Identifier: MIT
// The stages' names and numbers.
#pragma once

#include <array>
#include <string_view>

namespace stagelight {

// Stage 1 comes first.
constexpr std::array<std::string_view, 11> stage_names{
    "01_primitives", "02_shading_shadows", "03_reflection_glossy", "04_refraction_beer",
    "05_meshes",     "06_textures",        "07_interop",           "08_gamma",
    "09_tree",       "10_packets",         "11_full_tracer"};

// The number that a stage's folder, or a scene named after it, begins with.
inline int stage_number(std::string_view name) {
    return (name[0] - '0') * 10 + (name[1] - '0');
}

inline std::string_view stage_name(int number) {
    return stage_names[static_cast<std::size_t>(number - 1)];
}

}  // namespace stagelight
