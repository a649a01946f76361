// SPDX-License-Identifier: MIT
#include "bench/peers/contest.h"

#include <cstdlib>

#include <fmt/format.h>

namespace stagelight::bench {
namespace {

// A share of the pixels, or of the rays, that rounding may put on the other side of an edge.
constexpr double rounding_share = 1e-3;

int outliers_of(const Comparison &comparison) {
    return comparison.interior_outliers + comparison.edge_outliers + comparison.strays;
}

double megarays(const Contestant &contestant) {
    return static_cast<double>(contestant.rays) / median(contestant.milliseconds) / 1000;
}

// Empty when the picture and its rays are as they should be.
std::string fault_of(const Contestant &contestant, std::uint64_t expected_rays,
                     std::size_t pixels) {
    const auto difference =
        static_cast<double>(contestant.rays) - static_cast<double>(expected_rays);
    const Comparison &comparison = contestant.comparison;
    if (std::abs(difference) > rounding_share * static_cast<double>(expected_rays)) {
        return fmt::format("{} rays, expected {}", contestant.rays, expected_rays);
    }
    if (!(outliers_of(comparison) <= rounding_share * static_cast<double>(pixels))
        || !(std::abs(comparison.mean_signed_error) <= Tolerance().mean_signed_error)) {
        return to_string(comparison);
    }
    return "";
}

}  // namespace

bool agree(std::vector<Contestant> &contestants, const reference::Result &truth) {
    bool all_right = true;
    for (Contestant &contestant : contestants) {
        const Drawn drawn = contestant.draw();
        contestant.rays = drawn.rays;
        contestant.comparison = compare(drawn.image, truth.image, truth.edge, Tolerance());
        const std::string fault =
            fault_of(contestant, contestants.front().rays, truth.image.pixels.size());
        if (!fault.empty()) {
            fmt::print(stderr, "{} draws another picture than the reference: {}\n", contestant.name,
                       fault);
            all_right = false;
        }
    }
    return all_right;
}

void time_in_turn(std::vector<Contestant> &contestants, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        for (Contestant &contestant : contestants) {
            contestant.milliseconds.push_back(contestant.draw().milliseconds);
        }
    }
}

double ratio_of(const Contestant &other, const Contestant &one) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < one.milliseconds.size(); ++i) {
        ratios.push_back(other.milliseconds[i] / one.milliseconds[i]);
    }
    return median(std::move(ratios));
}

std::string table_of(const std::vector<Contestant> &contestants) {
    std::vector<std::vector<std::string>> rows{
        {"", "ms", "million rays/s", "times as long", "pixels off", "RMSE"}};
    for (const Contestant &contestant : contestants) {
        rows.push_back({contestant.name, fmt::format("{:.1f}", median(contestant.milliseconds)),
                        fmt::format("{:.1f}", megarays(contestant)),
                        fmt::format("{:.2f}", ratio_of(contestant, contestants.front())),
                        fmt::format("{}", outliers_of(contestant.comparison)),
                        fmt::format("{:.1e}", contestant.comparison.rmse)});
    }
    return table(rows);
}

ordered_json json_of(const std::vector<Contestant> &contestants) {
    ordered_json json = ordered_json::array();
    for (const Contestant &contestant : contestants) {
        json.push_back({{"name", contestant.name},
                        {"milliseconds", contestant.milliseconds},
                        {"median", median(contestant.milliseconds)},
                        {"rays", contestant.rays},
                        {"million_rays_per_second", megarays(contestant)},
                        {"times_as_long", ratio_of(contestant, contestants.front())},
                        {"pixels_off", outliers_of(contestant.comparison)},
                        {"rmse", contestant.comparison.rmse}});
    }
    return json;
}

}  // namespace stagelight::bench
