// SPDX-License-Identifier: MIT
// Stage 04: glass.
//
// A ray that meets glass splits in two. Snell's law says where they go, Schlick's approximation
// how the light is shared, and Beer's law what is lost inside.
//
// The lesson is in kernel.cl and in the modules of kernels/ that it names as new. This side
// of it, the same at every stage, is common/app/stage_program.cpp: read the scene, choose a
// device, build the kernel for what the scene has, hand it the scene, render, write.
#include "app/stage_program.h"

int main(int argc, char **argv) {
    return stagelight::run_stage("04_refraction_beer", argc, argv);
}
