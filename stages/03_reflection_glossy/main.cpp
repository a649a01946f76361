// SPDX-License-Identifier: MIT
// Stage 03: mirrors and glossy surfaces.
//
// What a mirror shows is found by tracing one more ray, and what a mirror in that mirror
// shows by another: rays wait on a stack, and a limit on bounces ends the game.
//
// The lesson is in kernel.cl and in the modules of kernels/ that it names as new. This side
// of it, the same at every stage, is common/app/stage_program.cpp: read the scene, choose a
// device, build the kernel for what the scene has, hand it the scene, render, write.
#include "app/stage_program.h"

int main(int argc, char **argv) {
    return stagelight::run_stage("03_reflection_glossy", argc, argv);
}
