// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/parts.h"
#include "scene/scene.h"

namespace stagelight {

// Turns the vertices' normals of a mesh whose triangles have been turned outwards, those in
// `turned` (of all triangles of the scene) just now. A ray is inside of glass or outside by these
// normals, so they must not contradict the triangle. But they may lean: on a smooth mesh one of
// three may point beneath its facet, and stays as it is. A vertex that has to serve both sides is
// copied. `places` is places_of the scene's vertices, and stays so.
void point_normals_outwards(Scene &scene, std::vector<std::uint32_t> &places,
                            const std::vector<Part> &parts, const std::vector<bool> &turned);

}  // namespace stagelight
