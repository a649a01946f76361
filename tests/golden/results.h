// SPDX-License-Identifier: MIT
// A scene held to its golden, and what is left of that for ./stagelight report.
#pragma once

#include <string>

#include "golden/suite.h"

namespace stagelight::golden {

struct Held {
    std::string failure;  // empty when within the tolerance; else one line
    Comparison comparison;
    Image picture, golden;
};

// The scene as the device that `device` stands for draws it, beside its golden. A golden that
// cannot be read, or is of another size than the suite's, is a failure like any other. Where
// STAGELIGHT_RESULTS names a folder, what was seen is left in there: SCENE_on_DEVICE.json and the
// pictures that it names. A check that does not come to its end leaves a file that says so.
Held hold_to_golden(const GoldenScene &scene, const std::string &device);

}  // namespace stagelight::golden
