// SPDX-License-Identifier: MIT
// What a scene asks of the stage that draws it, and which stage teaches that first.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

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

struct Lesson {
    std::string what;      // "dielectric material", "mesh", …
    int first_stage = 1;   // the number of the stage that teaches it
    SourceLocation where;  // the first place in the scene that asks for it
};

// The lessons a scene needs, in the order of their stages. A material counts when a
// shape uses it; the plain white one of shapes that name none asks for no lesson.
std::vector<Lesson> lessons_of(const Scene &scene);

// Throws UserError naming the first stage that can draw the scene, if `stage` can't.
void require_learnt(const Scene &scene, int stage);

}  // namespace stagelight
