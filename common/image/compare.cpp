// SPDX-License-Identifier: MIT
#include "image/compare.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/vec3.hpp>

#include "image/outliers.h"

namespace stagelight {
namespace {

double mean_signed_error(const Image &picture, const Image &truth) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        sum += glm::dvec3(picture.pixels[i]) - glm::dvec3(truth.pixels[i]);
    }
    sum /= double(truth.pixels.size());
    return std::max({sum.r, sum.g, sum.b},
                    [](double a, double b) { return std::abs(a) < std::abs(b); });
}

double root_mean_square_error(const Image &picture, const Image &truth) {
    double sum = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const glm::dvec3 error = glm::dvec3(picture.pixels[i]) - glm::dvec3(truth.pixels[i]);
        sum += error.r * error.r + error.g * error.g + error.b * error.b;
    }
    return std::sqrt(sum / (3 * double(truth.pixels.size())));
}

OIIO::ImageBuf buffer_of(const Image &image) {
    OIIO::ImageBuf buffer(OIIO::ImageSpec(image.width, image.height, 3, OIIO::TypeDesc::FLOAT));
    buffer.set_pixels(buffer.roi(), OIIO::TypeDesc::FLOAT, image.pixels.data());
    return buffer;
}

// Yee, A Perceptual Metric for Production Testing, 2004, as OpenImageIO has it: 2.4 asks its
// one-channel pictures of luminance for channel 1, so it sees differences of colour only.
int perceptual_failures(const Image &picture, const Image &truth) {
    OIIO::ImageBufAlgo::CompareResults results;
    return OIIO::ImageBufAlgo::compare_Yee(buffer_of(picture), buffer_of(truth), results);
}

std::string color(const glm::vec3 &value) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", value.r, value.g, value.b);
}

std::string not_finite(const char *name, const Image &image) {
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const glm::vec3 &c = image.at(x, y);
            if (!std::isfinite(c.r) || !std::isfinite(c.g) || !std::isfinite(c.b)) {
                return fmt::format("pixel ({}, {}) of the {} is not finite: {}", x, y, name,
                                   color(c));
            }
        }
    }
    return "";
}

// Why the two cannot be compared at all; empty when they can.
std::string incomparable(const Image &picture, const Image &truth) {
    if (picture.width != truth.width || picture.height != truth.height || truth.pixels.empty()) {
        return fmt::format("the picture is {}x{} pixels, the truth {}x{}", picture.width,
                           picture.height, truth.width, truth.height);
    }
    const std::string reason = not_finite("picture", picture);
    return reason.empty() ? not_finite("truth", truth) : reason;
}

std::string failure_of(const Comparison &figures, const Outliers &found, const Image &picture,
                       const Image &truth, const Tolerance &tolerance) {
    const auto worst = [&](const Worst &pixel) {
        return fmt::format("worst {:.3g} at ({}, {}): picture {}, truth {}", pixel.error, pixel.x,
                           pixel.y, color(picture.at(pixel.x, pixel.y)),
                           color(truth.at(pixel.x, pixel.y)));
    };
    std::vector<std::string> failures;
    if (found.interior > 0) {
        failures.push_back(fmt::format("{} interior pixels differ by more than {:.3g}, {}",
                                       found.interior, tolerance.interior,
                                       worst(found.worst_interior)));
    }
    if (found.edge > tolerance.edge_outliers) {
        failures.push_back(fmt::format("{} edge pixels match only a neighbour (allowed {}), {}",
                                       found.edge, tolerance.edge_outliers,
                                       worst(found.worst_edge)));
    }
    if (found.strays > tolerance.strays) {
        failures.push_back(
            fmt::format("{} edge pixels match no pixel of the 3x3 around (allowed {}), {}",
                        found.strays, tolerance.strays, worst(found.worst_stray)));
    }
    if (!(std::abs(figures.mean_signed_error) <= tolerance.mean_signed_error)) {
        failures.push_back(fmt::format("mean signed error {:.3g} (allowed {:.3g})",
                                       figures.mean_signed_error, tolerance.mean_signed_error));
    }
    return fmt::format("{}", fmt::join(failures, "; "));
}

}  // namespace

Comparison compare(const Image &picture, const Image &truth, const std::vector<std::uint8_t> &edge,
                   const Tolerance &tolerance) {
    assert(edge.size() == truth.pixels.size());
    Comparison figures;
    figures.failure = incomparable(picture, truth);
    if (!figures.failure.empty()) {
        return figures;
    }
    const Outliers found = find_outliers(picture, truth, edge, tolerance.interior);
    figures.interior_outliers = found.interior;
    figures.edge_outliers = found.edge;
    figures.strays = found.strays;
    figures.edge_pixels =
        int(std::count_if(edge.begin(), edge.end(), [](std::uint8_t e) { return e != 0; }));
    figures.worst_interior = found.worst_interior.error;
    figures.worst_x = found.worst_interior.x;
    figures.worst_y = found.worst_interior.y;
    figures.mean_signed_error = mean_signed_error(picture, truth);
    figures.rmse = root_mean_square_error(picture, truth);
    figures.psnr = -20 * std::log10(figures.rmse);
    figures.perceptual_failures = perceptual_failures(picture, truth);
    figures.failure = failure_of(figures, found, picture, truth, tolerance);
    return figures;
}

std::string to_string(const Comparison &figures) {
    return fmt::format("{} interior outliers (worst {:.3g} at ({}, {})), {} edge outliers and {} "
                       "strays of {} edge pixels, mean signed error {:.3g}, RMSE {:.3g}, PSNR "
                       "{:.1f} dB, {} perceptual failures",
                       figures.interior_outliers, figures.worst_interior, figures.worst_x,
                       figures.worst_y, figures.edge_outliers, figures.strays, figures.edge_pixels,
                       figures.mean_signed_error, figures.rmse, figures.psnr,
                       figures.perceptual_failures);
}

}  // namespace stagelight
