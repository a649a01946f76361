// SPDX-License-Identifier: MIT
// What a scene asks of the stage that draws it, and which stage is the first to have it.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

struct RequiredFeature {
    std::string what;          // "dielectric material", "mesh", …
    int first_stage = 1;       // the number of the stage that introduces it
    SourceLocation where;      // the first place in the scene that asks for it
    bool is_optional = false;  // a stage that lacks it draws the scene without
};

// In the order of their stages. A material counts when a shape uses it; the plain white one of
// shapes that name none asks for no feature.
std::vector<RequiredFeature> required_features(const Scene &scene);

// Throws UserError naming the first stage that can draw the scene, if `stage` can't.
void require_supported(const Scene &scene, int stage);

// Takes out of the scene what `stage` lacks and can draw it without: a line of warning each.
std::vector<std::string> take_out_unsupported(Scene &scene, int stage);

}  // namespace stagelight
