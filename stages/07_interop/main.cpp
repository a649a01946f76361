// SPDX-License-Identifier: MIT
// Stage 07: the window, and how a picture gets into it.
//
// OpenCL renders straight into an OpenGL texture where the device can share one; else the picture
// is copied while the next frame is rendered; else it goes to a file. --display chooses the rung to
// begin at, and the stats say which one held.
//
// The lesson is on both sides: kernels/picture.cl is what a kernel has to know of it, and
// common/display has a file for each rung, shared_rung.cpp and copy_rung.cpp.
#include "app/stage_program.h"

int main(int argc, char **argv) {
    return stagelight::run_stage("07_interop", argc, argv);
}
