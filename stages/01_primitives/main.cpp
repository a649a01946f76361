// SPDX-License-Identifier: MIT
// Stage 01: spheres and planes, and the ray that a pixel sees along.
//
// Nothing is lit yet: the picture shows the normal of what each ray hits first, as a colour,
// and its distance, as contour lines.
//
// The lesson is in kernel.cl and in the modules of kernels/ that it names as new. This side
// of it, the same at every stage, is common/app/stage_program.cpp: read the scene, choose a
// device, build the kernel for what the scene has, hand it the scene, render, write.
#include "app/stage_program.h"

int main(int argc, char **argv) {
    return stagelight::run_stage("01_primitives", argc, argv);
}
