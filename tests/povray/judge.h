// SPDX-License-Identifier: MIT
// POV-Ray 3.7 as a judge: the goldens' scenes as it draws them, beside the reference's pictures. It
// shares no line with us, and its geometry is in double.
#pragma once

#include <filesystem>
#include <vector>

#include "golden/suite.h"
#include "image/compare.h"
#include "image/image.h"
#include "reference/reference.h"

namespace stagelight::povray {

struct Verdict {
    Image povray;
    reference::Result truth;
    Comparison comparison;  // by golden/tolerances.toml, where POV-Ray is the device "povray"
};

// The goldens' scenes and a closed mesh of glass, which none of them has.
std::vector<golden::GoldenScene> judged_scenes();

// Exports the scene to `folder`, at the goldens' size, and has it drawn. By what both can:
// Fresnel's equations, and lights without a range.
Verdict judge(const golden::GoldenScene &golden, const std::filesystem::path &folder);

}  // namespace stagelight::povray
