// SPDX-License-Identifier: MIT
// Stage 08: gamma. Textures are decoded to light when they are loaded, the picture is encoded when
// it is written as PNG, and in between all is linear; EXR stays so.
//
// The lesson is in kernels/transfer_curves.h, and in kernel.cl, which has not changed. Where the
// curves are used is host code: common/device/texture_array.cpp and common/image/image_io.cpp.
// `06_textures scenes/08_gamma.toml` draws the same scene without.
#include "app/stage_program.h"

int main(int argc, char **argv) {
    return stagelight::run_stage("08_gamma", argc, argv);
}
