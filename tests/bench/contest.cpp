// SPDX-License-Identifier: MIT
#include "bench/contest.h"

#include <cstdlib>

#include <fmt/format.h>

namespace stagelight::bench {
namespace {

// A share of the rays, which rounding may add or spare.
constexpr double rounding_share = 1e-3;

double megarays(const Contestant &contestant) {
    return static_cast<double>(contestant.rays) / median(contestant.milliseconds) / 1000;
}

// Empty when the picture and its rays are as they should be.
std::string fault_of(const Contestant &contestant, std::uint64_t expected_rays,
                     const Agreement &agreement) {
    const auto difference =
        static_cast<double>(contestant.rays) - static_cast<double>(expected_rays);
    const auto pixels = static_cast<double>(contestant.image.pixels.size());
    const Comparison &comparison = contestant.comparison;
    if (contestant.rays > 0
        && std::abs(difference) > rounding_share * static_cast<double>(expected_rays)) {
        return fmt::format("{} rays, expected {}", contestant.rays, expected_rays);
    }
    if (!(comparison.interior_outliers <= agreement.inside * pixels)
        || !(comparison.edge_outliers + comparison.strays <= agreement.edges * pixels)
        || !(std::abs(comparison.mean_signed_error) <= agreement.mean_signed_error)) {
        return to_string(comparison);
    }
    return "";
}

}  // namespace

Contestant ours(Renderer &renderer, const std::string &stage) {
    return {stage, [&renderer] {
                Frame frame = renderer.render();
                return Drawn{std::move(frame.image), frame.rays.traced(), frame.milliseconds};
            }};
}

bool agree(std::vector<Contestant> &contestants, const reference::Result &truth,
           const Agreement &agreement) {
    bool all_right = true;
    for (Contestant &contestant : contestants) {
        Drawn drawn = contestant.draw();
        contestant.rays = drawn.rays;
        contestant.image = std::move(drawn.image);
        contestant.comparison = compare(contestant.image, truth.image, truth.edge, Tolerance());
        const std::string fault = fault_of(contestant, contestants.front().rays, agreement);
        if (!fault.empty()) {
            fmt::print(stderr, "{} draws another picture than the reference: {}\n", contestant.name,
                       fault);
            all_right = false;
        }
    }
    return all_right;
}

void time_in_turn(std::vector<Contestant> &contestants, int rounds) {
    const auto times = in_turn(contestants.size(), rounds,
                               [&](std::size_t i) { return contestants[i].draw().milliseconds; });
    for (std::size_t i = 0; i < contestants.size(); ++i) {
        contestants[i].milliseconds = times[i];
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
                        contestant.rays > 0 ? fmt::format("{:.1f}", megarays(contestant)) : "",
                        fmt::format("{:.2f}", ratio_of(contestant, contestants.front())),
                        fmt::format("{}", outliers_of(contestant.comparison)),
                        fmt::format("{:.1e}", contestant.comparison.rmse)});
    }
    return table(rows);
}

ordered_json json_of(const std::vector<Contestant> &contestants) {
    ordered_json json = ordered_json::array();
    for (const Contestant &contestant : contestants) {
        ordered_json counted;
        if (contestant.rays > 0) {
            counted = {{"rays", contestant.rays},
                       {"million_rays_per_second", megarays(contestant)}};
        }
        json.push_back({{"name", contestant.name},
                        {"milliseconds", contestant.milliseconds},
                        {"median", median(contestant.milliseconds)},
                        {"counted", counted},
                        {"times_as_long", ratio_of(contestant, contestants.front())},
                        {"pixels_off", outliers_of(contestant.comparison)},
                        {"rmse", contestant.comparison.rmse}});
    }
    return json;
}

}  // namespace stagelight::bench
