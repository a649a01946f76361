// SPDX-License-Identifier: MIT
#include "image/outliers.h"

#include <algorithm>
#include <cmath>

namespace stagelight {

double error_of(const glm::vec3 &picture, const glm::vec3 &truth) {
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
        const double p = picture[i], t = truth[i];
        worst = std::max(worst, std::abs(p - t) / std::max(1.0, std::abs(t)));
    }
    return worst;
}

namespace {

bool matches_a_neighbour(const glm::vec3 &pixel, const Image &truth, int x, int y,
                         double tolerance) {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, truth.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, truth.width - 1); ++u) {
            if (error_of(pixel, truth.at(u, v)) <= tolerance) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace

Outliers find_outliers(const Image &picture, const Image &truth,
                       const std::vector<std::uint8_t> &edge, double tolerance) {
    Outliers found;
    std::size_t i = 0;
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            const glm::vec3 &pixel = picture.at(x, y);
            const double error = error_of(pixel, truth.at(x, y));
            const bool outlier = !(error <= tolerance);
            if (edge[i++] == 0) {
                found.interior += outlier;
                found.worst_interior.see(error, x, y);
            } else if (outlier && matches_a_neighbour(pixel, truth, x, y, tolerance)) {
                ++found.edge;
                found.worst_edge.see(error, x, y);
            } else if (outlier) {
                ++found.strays;
                found.worst_stray.see(error, x, y);
            }
        }
    }
    return found;
}

}  // namespace stagelight
