// SPDX-License-Identifier: MIT
// What a kernel was built without, and why: the other side of its needs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "device/scene_needs.h"

namespace stagelight {

// What `stage` can draw, and `needs` shows that the scene has not; then why.
std::vector<std::pair<std::string, std::string>> left_out(const SceneNeeds &needs, int stage);

}  // namespace stagelight
