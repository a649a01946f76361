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

Outlier outlier_at(const Image &picture, const Image &truth, const std::vector<std::uint8_t> &edge,
                   double tolerance, int x, int y) {
    const glm::vec3 &pixel = picture.at(x, y);
    if (error_of(pixel, truth.at(x, y)) <= tolerance) {
        return Outlier::none;
    }
    if (edge[std::size_t(y) * std::size_t(truth.width) + std::size_t(x)] == 0) {
        return Outlier::interior;
    }
    return matches_a_neighbour(pixel, truth, x, y, tolerance) ? Outlier::edge : Outlier::stray;
}

Outliers find_outliers(const Image &picture, const Image &truth,
                       const std::vector<std::uint8_t> &edge, double tolerance) {
    Outliers found;
    std::size_t i = 0;
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            const double error = error_of(picture.at(x, y), truth.at(x, y));
            const Outlier kind = outlier_at(picture, truth, edge, tolerance, x, y);
            if (edge[i++] == 0) {
                found.interior += kind == Outlier::interior;
                found.worst_interior.see(error, x, y);
            } else if (kind == Outlier::edge) {
                ++found.edge;
                found.worst_edge.see(error, x, y);
            } else if (kind == Outlier::stray) {
                ++found.strays;
                found.worst_stray.see(error, x, y);
            }
        }
    }
    return found;
}

}  // namespace stagelight
