// SPDX-License-Identifier: MIT
// POV-Ray 3.7, as a program.
#pragma once

#include <filesystem>

#include "image/image.h"

namespace stagelight::bench {

struct PovRayPicture {
    Image image;
    double parsing = 0;  // milliseconds, by its own clock: reading the scene
    double tracing = 0;  // by its own clock: the picture
    double wall = 0;     // from its start to its end
};

// Draws `scene`, exported with a picture of width x height pixels, one ray a pixel, with as many
// threads. What it says and draws lies beside the scene. Throws MachineError where that fails.
PovRayPicture run_povray(const std::filesystem::path &scene, int width, int height, int threads);

}  // namespace stagelight::bench
