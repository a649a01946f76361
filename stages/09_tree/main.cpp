// SPDX-License-Identifier: MIT
// Stage 09: a tree of boxes, so that a ray tries a few dozen triangles instead of all.
//
// The host builds it, on all cores: common/device/bvh.cpp. The kernel walks it:
// kernels/packets/walk.cl.
#include "app/stage_program.h"

int main(int argc, char **argv) {
    return stagelight::run_stage("09_tree", argc, argv);
}
