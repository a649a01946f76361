// SPDX-License-Identifier: MIT
// Stage 02: diffuse shading, point and directional lights, hard shadows.
//
// A point that sees a light is lit by it. Whether it does is asked with a line that ends at a
// point light, and with a ray that has no end for a directional one.
//
// The lesson is in kernel.cl and in the modules of kernels/ that it names as new. This side
// of it, the same at every stage, is common/app/stage_program.cpp: read the scene, choose a
// device, build the kernel for what the scene has, hand it the scene, render, write.
#include "app/stage_program.h"

int main(int argc, char **argv) {
    return stagelight::run_stage("02_shading_shadows", argc, argv);
}
