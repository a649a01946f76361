// SPDX-License-Identifier: MIT
#include "app/stats.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "device/disabled_features.h"
#include "image/whole_file.h"
#include "scene/progress.h"
#include "scene/radiance_bound.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

using nlohmann::ordered_json;

ordered_json needs_json(const SceneNeeds &needs) {
    ordered_json json = ordered_json::object();
    for (const auto &[name, value] : needs) {
        json[name] = value;
    }
    return json;
}

ordered_json disabled_features_json(const SceneNeeds &needs, int stage) {
    ordered_json json = ordered_json::object();
    for (const auto &[what, why] : disabled_features(needs, stage)) {
        json[what] = why;
    }
    return json;
}

// No pixel is off by more because of the rays that were cut off.
double cutoff_error(const RayTotals &rays, const Scene &scene) {
    return rays.cut_off > 0 ? rays.cut_off_weight * radiance_bound(scene) : 0;
}

ordered_json cut_off_json(const RayTotals &rays, const Scene &scene) {
    return {{"count", rays.cut_off},
            {"largest_sum_of_weights", rays.cut_off_weight},
            {"radiance_bound", radiance_bound(scene)},
            {"error_at_most", cutoff_error(rays, scene)}};
}

ordered_json methods_json(int stage, const Methods &chosen) {
    ordered_json json = ordered_json::object();
    for (const Method &method : methods_of(stage)) {
        json[method.kind] = choice(chosen, method.kind, stage);
    }
    return json;
}

ordered_json startup_json(const Startup &startup) {
    ordered_json json = ordered_json::object();
    for (const auto &[part, milliseconds] : startup.parts()) {
        json[part] = milliseconds;
    }
    json["total"] = startup.total();
    return json;
}

// "812 ms: start 240, scene 75, …", without what rounds to nothing.
std::string to_string(const Startup &startup) {
    std::string text = fmt::format("{:.0f} ms:", startup.total());
    for (const auto &[part, milliseconds] : startup.parts()) {
        if (milliseconds >= 0.5) {
            text += fmt::format(" {} {:.0f},", part, milliseconds);
        }
    }
    text.pop_back();
    return text;
}

// The last frames: from when to when each was rendered and presented, milliseconds.
ordered_json timeline_json(const std::vector<FrameTimes> &frames) {
    constexpr std::size_t most = 8;
    const std::size_t first = frames.size() > most ? frames.size() - most : 0;
    const double start = frames[first].render.begin;
    ordered_json timeline = ordered_json::array();
    for (std::size_t i = first; i < frames.size(); ++i) {
        const auto [render, present, milliseconds] = frames[i];
        timeline.push_back({{"render", {render.begin - start, render.end - start}},
                            {"present", {present.begin - start, present.end - start}}});
    }
    return timeline;
}

ordered_json display_json(const DisplayFigures &display) {
    ordered_json json = {{"path", display.path}, {"reason", display.reason}};
    if (!display.frames.empty()) {
        json["api"] = display.api;
        json["color_bits"] = display.color_bits;
        json["framebuffer"] = {display.width, display.height};
        json["render_median"] = median_of(
            display.frames, [](const FrameTimes &frame) { return frame.render.length(); });
        json["present_median"] = median_of(
            display.frames, [](const FrameTimes &frame) { return frame.present.length(); });
        json["overlap"] = overlap_of(display.frames);
        json["timeline"] = timeline_json(display.frames);
    }
    return json;
}

// Device, driver, build options, milliseconds a frame and from start to picture, rays by kind,
// dropped rays, bytes on the device, what the scene needed and what was disabled, how the frames
// came to the window, and all warnings.
std::string stats_json(const Run &run, const RunResult &result) {
    const int stage = stage_number(run.stage);
    const RenderSettings &settings = result.settings;
    const ordered_json json = {
        {"stage", run.stage},
        {"device", device_json(result.device)},
        {"build", {{"options", result.build_options}, {"milliseconds", result.build_milliseconds}}},
        {"startup", startup_json(run.startup)},
        {"size", {settings.width, settings.height}},
        {"samples", settings.samples},
        {"max_depth", settings.max_depth},
        {"methods", methods_json(stage, settings.methods)},
        {"frames", {{"milliseconds", result.frames}, {"median", median(result.frames)}}},
        {"rays", rays_json(result.rays)},
        {"dropped_rays", result.rays.dropped},
        {"cut_off_rays", cut_off_json(result.rays, run.scene)},
        {"bytes_on_device", bytes_json(result.bytes_on_device)},
        {"needs", needs_json(result.needs)},
        {"disabled_features", disabled_features_json(result.needs, stage)},
        {"display", display_json(result.display)},
        {"warnings", all_warnings()},
    };
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

void report_details(const Run &run, const RunResult &result) {
    fmt::print("kernel built in {:.0f} ms; from start to picture: {}\n", result.build_milliseconds,
               to_string(run.startup));
    if (result.rays.dropped > 0) {
        fmt::print("{} rays dropped: deeper than {} bounces (--depth)\n", result.rays.dropped,
                   result.settings.max_depth);
    }
    if (result.rays.cut_off > 0) {
        fmt::print("{} rays not traced, each below 1/{} of a pixel: no pixel is off by more than "
                   "{:.2g}\n",
                   result.rays.cut_off, cutoff_of(result.settings.methods),
                   cutoff_error(result.rays, run.scene));
    }
    std::string disabled;
    for (const auto &[what, why] : disabled_features(result.needs, stage_number(run.stage))) {
        disabled +=
            (disabled.empty() ? "not in the kernel, as this scene needs none: " : ", ") + what;
    }
    if (!disabled.empty()) {
        fmt::print("{}\n", disabled);
    }
}

}  // namespace

ordered_json device_json(const cl::Device &device) {
    return {{"name", device.getInfo<CL_DEVICE_NAME>()},
            {"platform", platform_of(device).getInfo<CL_PLATFORM_NAME>()},
            {"version", device.getInfo<CL_DEVICE_VERSION>()},
            {"driver", device.getInfo<CL_DRIVER_VERSION>()},
            {"compute_units", device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>()}};
}

ordered_json rays_json(const RayTotals &rays) {
    return {{"primary", rays.primary},
            {"shadow", rays.shadow},
            {"reflection", rays.reflection},
            {"refraction", rays.refraction}};
}

ordered_json bytes_json(const std::map<std::string, std::size_t> &sizes) {
    ordered_json bytes;
    std::size_t total = 0;
    for (const auto &[name, size] : sizes) {
        bytes[name] = size;
        total += size;
    }
    bytes["total"] = total;
    return bytes;
}

double overlap_of(const std::vector<FrameTimes> &frames) {
    double presenting = 0;
    double both = 0;
    for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
        const Interval &present = frames[i].present;
        const Interval &render = frames[i + 1].render;
        presenting += present.length();
        both += std::max(0.0,
                         std::min(present.end, render.end) - std::max(present.begin, render.begin));
    }
    return presenting > 0 ? both / presenting : 0;
}

double median(std::vector<double> values) {
    assert(!values.empty());
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

void report(const Run &run, const RunResult &result) {
    if (run.options.stats) {
        const std::string json = stats_json(run, result);
        write_whole(std::vector<unsigned char>(json.begin(), json.end()), *run.options.stats);
    }
    const double milliseconds = median(result.frames);
    const RenderSettings &settings = result.settings;
    fmt::print("{}\n", result.device.getInfo<CL_DEVICE_NAME>());
    fmt::print(
        "{}x{}, {} sample{} a pixel: {:.1f} ms, {:.2f} million rays, {:.1f} million a second\n",
        settings.width, settings.height, settings.samples, settings.samples == 1 ? "" : "s",
        milliseconds, static_cast<double>(result.rays.traced()) / 1e6,
        result.rays.rate(milliseconds));
    if (run.options.verbose) {
        report_details(run, result);
    }
}

}  // namespace stagelight
