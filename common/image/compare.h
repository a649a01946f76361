// SPDX-License-Identifier: MIT
// How a picture is judged against a true one, in linear light.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "image/image.h"

namespace stagelight {

struct Tolerance {
    double interior = 1.0 / 255;      // absolute or relative, whichever is larger
    int edge_outliers = 0;            // pixels on an edge allowed beyond it that match a neighbour
    int strays = 0;                   // and that match none: where several edges meet, in glass
    double mean_signed_error = 1e-4;  // |mean over all pixels of (picture - truth)|, each channel
};

struct Comparison {
    static constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

    int interior_outliers = 0;       // interior pixels beyond the tolerance
    int edge_outliers = 0;           // edge pixels beyond it that match a neighbour (3x3)
    int strays = 0;                  // edge pixels that match none of the 3x3 around
    int edge_pixels = 0;             // size of the mask
    double worst_interior = 0;       // min(absolute, relative) error of the worst channel
    int worst_x = -1, worst_y = -1;  // where that is; -1 with no interior pixel
    // NaN where the two cannot be compared.
    double mean_signed_error = not_known;  // the channel of the largest magnitude
    double rmse = not_known;
    double psnr = not_known;      // dB, peak 1
    int perceptual_failures = 0;  // OIIO compare_Yee: of colour, not of brightness
    std::string failure;          // empty when within the tolerance; else one line
};

// `edge` has one byte a pixel of `truth`. A difference of size, a NaN or an infinity in
// either picture fails always.
Comparison compare(const Image &picture, const Image &truth, const std::vector<std::uint8_t> &edge,
                   const Tolerance &tolerance);

// One line of the figures, for test output and `golden`.
std::string to_string(const Comparison &comparison);

}  // namespace stagelight
