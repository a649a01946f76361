// SPDX-License-Identifier: MIT
// Stage 10: packets. Rays of neighbouring pixels are traced side by side, in the lanes of a CPU's
// vectors.
//
// What one ray does in stage 09, 16 do here at once (kernels/packets/wide.cl), and 64 as a beam
// (kernels/packets/beam.cl).
#include "app/stage_program.h"

int main(int argc, char **argv) {
    return stagelight::run_stage("10_packets", argc, argv);
}
