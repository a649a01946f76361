// SPDX-License-Identifier: MIT
// Stage 05: triangle meshes.
//
// Assimp reads them in any format, with their materials; the kernel tries every triangle for
// every ray.
//
// The lesson is in kernel.cl and in the modules of kernels/ that it names as new. This side
// of it, the same at every stage, is common/app/stage_program.cpp: read the scene, choose a
// device, build the kernel for what the scene has, hand it the scene, render, write.
#include "app/stage_program.h"

int main(int argc, char **argv) {
    return stagelight::run_stage("05_meshes", argc, argv);
}
