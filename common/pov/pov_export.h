// SPDX-License-Identifier: MIT
// A scene as POV-Ray 3.7 reads it, so that another ray tracer draws the same picture. What it means
// is docs/shading.md's, said in POV-Ray's words; docs/pov-ray.md tells what these cannot say.
#pragma once

#include <filesystem>

#include "image/transfer.h"
#include "scene/scene.h"

namespace stagelight {

struct PovSettings {
    int width = 640;   // pixels
    int height = 384;  // pixels
    int max_depth = 8;
    Transfer decode = Transfer::none;  // which curve takes texels to light
    bool shows_normals = false;        // and distances, as stage 01 does, in place of light
};

// Writes `file`, and beside it a picture in linear light for each textured material. Throws
// UserError for what POV-Ray has no words for, before anything is written, and where a file can't
// be written.
void export_pov(const Scene &scene, const PovSettings &settings, const std::filesystem::path &file);

}  // namespace stagelight
