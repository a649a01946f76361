// SPDX-License-Identifier: MIT
// Model no more than a scene needs: what it has is worked out once, and becomes the names that
// the kernels are built with.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

// From this stage on a ray that carries less than one part in `cutoff_one_in` of a pixel is not
// traced, and the depth follows from the scene. Measured at 320x192 on the room, Suzanne in glass
// and the amber of 04_interior: no pixel is off by more than 0.00094, a quarter of 1/255, and none
// by more than one code of an sRGB picture, for 20, 45 and 42 % fewer rays; with 1/1024 by 0.0038,
// and by four codes and more.
constexpr int cutoff_stage = 11;
constexpr int cutoff_one_in = 4096;

// How many bounces `stage` follows where no --depth says it: what the scene's file says, else 8;
// but from stage 11 on no more than it takes until every ray is cut off, where the materials'
// colours and shares alone see to that, and then at most 16.
int depth_of(const Scene &scene, int stage);

// Name and value of what is not 0, in a fixed order.
using SceneNeeds = std::vector<std::pair<std::string, int>>;

// `stage` is the number of the stage that draws: 01 knows neither materials nor lights. Where the
// stage has that, rays are cut off that carry less than one part in `cutoff` of a pixel; none is at
// 0. And with `smooth_shadows` a smooth mesh gets light as what it stands for does.
SceneNeeds needs_of(const Scene &scene, int stage, int max_depth, int cutoff = cutoff_one_in,
                    bool smooth_shadows = true);

// 0 for what is not among them.
int value_of(const SceneNeeds &needs, const std::string &name);

// Every name that kernels ask for, as options of their compiler: what is not among the needs as 0,
// or where a number of things is meant, as the smallest that builds.
std::string definitions_of(const SceneNeeds &needs);

// Whether any triangle's material has a texture.
bool has_textured_mesh(const Scene &scene);
// Whether any texture does other than repeat.
bool has_wraps(const Scene &scene);
// Whether any triangle's material is cut out by its texture's alpha.
bool has_cutouts(const Scene &scene);

}  // namespace stagelight
