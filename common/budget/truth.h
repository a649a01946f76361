// SPDX-License-Identifier: MIT
// What a picture by approximate methods is held to.
#pragma once

#include "device/stage_kernel.h"
#include "image/image.h"
#include "reference/reference.h"
#include "scene/scene.h"

namespace stagelight {

// The scene by the reference in double, as `stage` draws it by these settings, one sample a pixel:
// but with Fresnel's own equations, all reflections inside of glass, smooth meshes lit as what they
// stand for (from stage 11 on), and texels as sRGB, whatever methods are chosen. The depth limit is
// that of the settings.
reference::Result truth_of(const std::string &stage, const Scene &scene,
                           const RenderSettings &settings);

// The root of the mean square of what they differ by, over all pixels and channels, in linear
// light; not a number in either makes it infinite. Of pictures of one size.
double rmse_of(const Image &picture, const Image &truth);

}  // namespace stagelight
