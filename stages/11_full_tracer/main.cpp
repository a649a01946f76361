// SPDX-License-Identifier: MIT
// Stage 11: the full tracer. Everything together, glass of any shape, and only what a scene needs.
//
// What is new in the kernel: kernels/dielectric.cl (meshes, exact Fresnel) and kernels/ray_stack.cl
// (rays too weak to matter). How deep rays go the host derives: common/device/scene_needs.cpp.
#include "app/stage_program.h"

int main(int argc, char **argv) {
    return stagelight::run_stage("11_full_tracer", argc, argv);
}
