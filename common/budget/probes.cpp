// SPDX-License-Identifier: MIT
#include "budget/probes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "budget/fingerprint.h"
#include "budget/truth.h"
#include "device/device_choice.h"
#include "image/whole_file.h"
#include "scene/errors.h"
#include "scene/progress.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

constexpr int probe_width = 320;  // large enough for a frame to take longer than to start it
constexpr int rounds = 7;

RenderSettings small(RenderSettings settings) {
    const int width = std::min(settings.width, probe_width);
    settings.height = std::max(1, settings.height * width / settings.width);
    settings.width = width;
    return settings;
}

struct Variant {
    Probe probe;
    RenderSettings settings;
};

std::vector<Variant> variants_of(const std::string &stage, const Scene &scene,
                                 const RenderSettings &settings, const RenderSettings &base) {
    const int number = stage_number(stage);
    const SceneNeeds needs = needs_of(scene, number, base.max_depth);
    std::vector<Variant> variants;
    for (const Method &method : methods_of(number)) {
        if (is_approximate(method.kind) && matters(method.kind, needs)
            && !settings.methods.contains(method.kind)
            && method.name != choice(base.methods, method.kind, number) && method.name != "fp64") {
            variants.push_back({{method.kind, method.name}, base});
            variants.back().settings.methods[method.kind] = method.name;
        }
    }
    if (matters("depth", needs)) {
        for (const int limit : limits_below(base.max_depth)) {
            variants.push_back({{"limit", std::to_string(limit)}, base});
            variants.back().settings.max_depth = limit;
        }
    }
    return variants;
}

std::optional<Probe> probe_double(const cl::Device &device, const std::string &stage,
                                  const Scene &scene, RenderSettings settings, Renderer &base,
                                  const Image &truth) {
    if (settings.methods.contains("math") || !has_extension(device, "cl_khr_fp64")) {
        return std::nullopt;
    }
    settings.methods["math"] = "fp64";
    Renderer renderer(device, stage, scene, settings);
    const double error = rmse_of(renderer.render().image, truth);
    return Probe{"math", "fp64", time_ratio(renderer, base, rounds), error};
}

void measure(Variant &variant, const cl::Device &device, const std::string &stage,
             const Scene &scene, Renderer &base, const Image &base_picture) {
    Renderer renderer(device, stage, scene, variant.settings);
    const double error = rmse_of(renderer.render().image, base_picture);
    // What is no number is as wrong as can be (math=relaxed on LLVM 21 draws such pixels).
    variant.probe.error = std::isfinite(error) ? error : std::numeric_limits<double>::max();
    variant.probe.ratio = time_ratio(renderer, base, rounds);
}

Probes measure_all(const cl::Device &device, const std::string &stage, const Scene &scene,
                   const RenderSettings &settings) {
    RenderSettings base = small(settings);
    base.methods.emplace("fresnel", "exact");  // unless the user chose
    std::vector<Variant> variants = variants_of(stage, scene, settings, base);
    Progress progress("probing methods", variants.size() + 2);
    Probes probes{base.methods, 0, {}};
    Renderer renderer(device, stage, scene, base);
    const Image picture = renderer.render().image;
    const Image truth = truth_of(stage, scene, base).image;
    probes.base_error = rmse_of(picture, truth);
    progress.step();
    probes.in_double = probe_double(device, stage, scene, base, renderer, truth);
    progress.step();
    for (Variant &variant : variants) {
        measure(variant, device, stage, scene, renderer, picture);
        probes.probes.push_back(variant.probe);
        progress.step();
    }
    return probes;
}

// Empty where the user has no such folder.
std::filesystem::path cache_folder() {
    const char *cache = std::getenv("XDG_CACHE_HOME");
    const char *home = std::getenv("HOME");
    if (cache != nullptr && *cache != '\0') {
        return std::filesystem::path(cache) / "stagelight";
    }
    return home != nullptr ? std::filesystem::path(home) / ".cache" / "stagelight"
                           : std::filesystem::path();
}

Probe probe_from(const nlohmann::json &json) {
    return {json.at("kind"), json.at("name"), json.at("ratio"), json.at("error")};
}

nlohmann::ordered_json json_of(const Probe &probe) {
    return {
        {"kind", probe.kind}, {"name", probe.name}, {"ratio", probe.ratio}, {"error", probe.error}};
}

// Nothing where there is none, or what is there was not written by this program.
std::optional<Probes> read_probes(const std::filesystem::path &file) {
    std::ifstream in(file);
    const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
    try {
        Probes probes{json.at("base"), json.at("base_error"), {}};
        for (const nlohmann::json &probe : json.at("probes")) {
            probes.probes.push_back(probe_from(probe));
        }
        if (json.contains("in_double")) {
            probes.in_double = probe_from(json.at("in_double"));
        }
        return probes;
    } catch (const nlohmann::json::exception &) {
        return std::nullopt;
    }
}

void write_probes(const Probes &probes, const std::filesystem::path &file) {
    nlohmann::ordered_json json{{"base", probes.base}, {"base_error", probes.base_error}};
    for (const Probe &probe : probes.probes) {
        json["probes"].push_back(json_of(probe));
    }
    if (probes.in_double) {
        json["in_double"] = json_of(*probes.in_double);
    }
    const std::string text = json.dump(1);
    std::error_code failed;
    std::filesystem::create_directories(file.parent_path(), failed);
    try {
        write_whole(std::vector<unsigned char>(text.begin(), text.end()), file);
    } catch (const UserError &) {
        return;  // nobody asked for the file
    }
}

}  // namespace

bool is_approximate(const std::string &kind) {
    constexpr std::array others{"width", "walk", "decode", "encode"};
    return std::ranges::find(others, kind) == others.end();
}

std::vector<int> limits_below(int max_depth) {
    std::vector<int> limits{1, 2, 3, 4, 6, 8, 12};
    std::erase_if(limits, [max_depth](int limit) { return limit >= max_depth; });
    return limits;
}

double time_ratio(Renderer &one, Renderer &other, int pairs) {
    std::vector<double> ratios;
    for (int i = 0; i < pairs; ++i) {
        const double of_other = other.render().milliseconds;
        ratios.push_back(one.render().milliseconds / of_other);
    }
    const auto middle = ratios.begin() + pairs / 2;
    std::ranges::nth_element(ratios, middle);
    return *middle;
}

Probes probe_methods(const cl::Device &device, const std::string &stage, const Scene &scene,
                     const RenderSettings &settings) {
    const std::filesystem::path folder = cache_folder();
    const std::filesystem::path file =
        folder / fmt::format("probes-{:016x}.json", fingerprint(device, stage, scene, settings));
    if (const std::optional<Probes> known = read_probes(file)) {
        return *known;
    }
    Probes probes = measure_all(device, stage, scene, settings);
    if (!folder.empty()) {
        write_probes(probes, file);
    }
    return probes;
}

}  // namespace stagelight
