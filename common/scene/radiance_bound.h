// SPDX-License-Identifier: MIT
// The most light that any ray of a scene can bring.
#pragma once

#include "scene/scene.h"

namespace stagelight {

// In the largest channel, linear: no less than the background, and than all lights together shine
// on the surfaces nearest to each. No material sends on more light than falls on it, since colours
// and shares are at most 1, so that holds after any number of bounces. Infinite where a point light
// lies on a surface.
double radiance_bound(const Scene &scene);

}  // namespace stagelight
