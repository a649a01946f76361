// SPDX-License-Identifier: MIT
// What a kernel was built without, and why: the other side of its needs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "device/scene_needs.h"

namespace stagelight {

// What `stage` can draw and a scene of those needs does not ask for, each with the reason.
std::vector<std::pair<std::string, std::string>> disabled_features(const SceneNeeds &needs,
                                                                   int stage);

}  // namespace stagelight
