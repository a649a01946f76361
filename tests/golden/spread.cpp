// SPDX-License-Identifier: MIT
#include "golden/spread.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "golden/suite.h"
#include "implementations.h"
#include "scene/stages.h"

namespace stagelight::golden {
namespace {

struct Variant {
    std::string device;
    Methods methods;
};

// rusticl takes minutes to build what is wide.
std::vector<Variant> variants_of(const GoldenScene &scene) {
    std::vector<Variant> variants;
    for (const char *device : implementations) {
        variants.push_back({device, {}});
    }
    const std::string pocl = implementations[0];
    for (const char *math : {"mad", "relaxed"}) {
        variants.push_back({pocl, {{"math", math}}});
    }
    if (stage_number(scene.stage) >= packet_stage) {
        for (const char *width : {"1", "4", "8", "16"}) {
            variants.push_back({pocl, {{"width", width}}});
        }
    }
    return variants;
}

class Spread {
public:
    void add(const GoldenScene &scene, const Variant &variant, const Image &truth,
             const std::vector<std::uint8_t> &edge, const Image &picture) {
        std::string by = scene.name + ", " + variant.device;
        for (const auto &[kind, name] : variant.methods) {
            by += fmt::format(", {}={}", kind, name);
        }
        const Comparison comparison =
            compare(picture, truth, edge, tolerance_of(scene.name, variant.device));
        const auto see = [&](const char *key, double value) {
            const Bound bound = bound_of(scene.name, variant.device, key);
            see_one({bound.place, key, bound.value, value, by});
        };
        if (std::isnan(comparison.rmse)) {
            see("interior", INFINITY);  // there is nothing to compare
            return;
        }
        see("interior", comparison.worst_interior);
        see("mean_signed_error", std::abs(comparison.mean_signed_error));
        see("edge_outliers", comparison.edge_outliers);
        see("strays", comparison.strays);
    }

    void add_unseen(const GoldenScene &scene, const Variant &variant, std::size_t unseen) {
        const Bound bound = bound_of(scene.name, variant.device, "unseen");
        see_one({bound.place, "unseen", bound.value, double(unseen),
                 scene.name + ", " + variant.device});
    }

    std::vector<Needed> take() { return std::move(all_); }

private:
    void see_one(const Needed &seen) {
        const auto known = std::ranges::find_if(all_, [&seen](const Needed &other) {
            return other.place == seen.place && other.key == seen.key;
        });
        if (known == all_.end()) {
            all_.push_back(seen);
        } else if (seen.needed > known->needed) {
            *known = seen;
        }
    }

    std::vector<Needed> all_;
};

bool is_count(const std::string &key) {
    return key != "interior" && key != "mean_signed_error";
}

double least(const std::string &key) {
    constexpr double half_rounding = 1.0 / 2048;  // relative, of a golden's light
    return is_count(key) ? 0.5 : key == "interior" ? half_rounding : half_rounding / 32;
}

}  // namespace

bool is_too_loose(const std::string &key, double bound, double needed) {
    return bound > 5 * std::max(needed, least(key));
}

double proposed_bound(const std::string &key, double needed) {
    if (is_count(key)) {
        return 2 * needed;
    }
    const double twice = 2 * std::max(needed, least(key));
    const double unit = std::pow(10, std::floor(std::log10(twice)) - 1);
    return std::ceil(twice / unit) * unit;  // two digits
}

std::vector<Needed> measure_spread(const std::function<void()> &progress) {
    Spread spread;
    for (const GoldenScene &scene : all_scenes()) {
        const stagelight::Golden golden = read_golden(scene.golden);
        const reference::Result truth = draw_reference(scene);
        for (const Variant &variant : variants_of(scene)) {
            const Image picture = draw_device(scene, variant.device, variant.methods);
            spread.add(scene, variant, golden.image, golden.edge, picture);
            spread.add(scene, variant, truth.image, truth.edge, picture);
            if (variant.methods.empty() && stage_number(scene.stage) > 1) {
                const double interior = tolerance_of(scene.name, variant.device).interior;
                spread.add_unseen(scene, variant,
                                  unseen_pixels(scene, picture, truth.image, interior).size());
            }
        }
        progress();
    }
    return spread.take();
}

}  // namespace stagelight::golden
