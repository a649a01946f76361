// SPDX-License-Identifier: MIT
// POV-Ray 3.7 as a judge: scenes as it draws them, beside the reference's pictures. It shares no
// line with us, and its geometry is in double.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "image/compare.h"
#include "image/image.h"
#include "reference/reference.h"

namespace stagelight::povray {

struct JudgedScene {
    std::string name;   // "11_whisky"
    std::string stage;  // "11_full_tracer"
    std::filesystem::path file;
    int width = 0;   // pixels
    int height = 0;  // pixels
};

// For GoogleTest, which else shows bytes.
inline void PrintTo(const JudgedScene &scene, std::ostream *out) {
    *out << scene.name;
}

struct Verdict {
    Image povray;
    reference::Result truth;
    Comparison comparison;  // by golden/tolerances.toml, where POV-Ray is the device "povray"
};

// The goldens' scenes, at their size, a closed mesh of glass, which none of them has, and the small
// ones of tests/povray.
std::vector<JudgedScene> judged_scenes();

// Exports the scene to `folder` and has it drawn. By what both can: Fresnel's equations, and lights
// without a range.
Verdict judge(const JudgedScene &judged, const std::filesystem::path &folder);

}  // namespace stagelight::povray
