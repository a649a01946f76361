// SPDX-License-Identifier: MIT
// Stage 07: the window, and how a picture gets into it.
//
// OpenCL renders straight into an OpenGL texture where the device can share one; else the picture
// is copied while the next frame is rendered; else it goes to a file. --display chooses the path to
// try first, and the stats say which one worked.
//
// The lesson is on both sides: kernels/picture.cl is what a kernel has to know of it, and
// common/display has a presenter for each, shared_presenter.cpp and copy_presenter.cpp.
#include "app/stage_program.h"

int main(int argc, char **argv) {
    return stagelight::run_stage("07_interop", argc, argv);
}
