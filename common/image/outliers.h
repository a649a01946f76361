// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace stagelight {

// min(absolute, relative) error of the worst channel: |p - t| / max(1, |t|).
double error_of(const glm::vec3 &picture, const glm::vec3 &truth);

// The pixel of the largest error of a kind.
struct Worst {
    double error = 0;
    int x = -1, y = -1;

    void see(double other, int other_x, int other_y) {
        if (x < 0 || other > error) {
            *this = {other, other_x, other_y};
        }
    }
};

struct Outliers {
    int interior = 0, edge = 0, strays = 0;
    Worst worst_interior, worst_edge, worst_stray;
};

// A pixel beyond the tolerance of the truth: inside a surface, on an edge where it matches a pixel
// of the 3x3 around, or a stray, on an edge too, that matches none.
enum class Outlier { none, interior, edge, stray };

// `edge` has one byte a pixel; the pictures are of one size.
Outlier outlier_at(const Image &picture, const Image &truth, const std::vector<std::uint8_t> &edge,
                   double tolerance, int x, int y);

Outliers find_outliers(const Image &picture, const Image &truth,
                       const std::vector<std::uint8_t> &edge, double tolerance);

}  // namespace stagelight
