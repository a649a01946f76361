// SPDX-License-Identifier: MIT
#include "app/stats.h"

#include <algorithm>
#include <cassert>

#include <nlohmann/json.hpp>

#include "scene/lessons.h"

namespace stagelight {
namespace {

using nlohmann::ordered_json;

ordered_json device_json(const cl::Device &device) {
    const cl::Platform platform(device.getInfo<CL_DEVICE_PLATFORM>());
    return {{"name", device.getInfo<CL_DEVICE_NAME>()},
            {"platform", platform.getInfo<CL_PLATFORM_NAME>()},
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

ordered_json bytes_json(const Renderer &renderer) {
    ordered_json bytes;
    std::size_t total = 0;
    for (const auto &[name, size] : renderer.bytes()) {
        bytes[name] = size;
        total += size;
    }
    bytes["total"] = total;
    return bytes;
}

ordered_json needs_json(const SceneNeeds &needs) {
    ordered_json json = ordered_json::object();
    for (const auto &[name, value] : needs) {
        json[name] = value;
    }
    return json;
}

ordered_json methods_json(int stage, const Methods &chosen) {
    ordered_json json = ordered_json::object();
    for (const Method &method : methods_of(stage)) {
        if (!json.contains(method.kind)) {
            const auto choice = chosen.find(method.kind);
            json[method.kind] = choice == chosen.end() ? method.name : choice->second;
        }
    }
    return json;
}

}  // namespace

double median(std::vector<double> values) {
    assert(!values.empty());
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

std::string stats_json(const std::string &stage, const Renderer &renderer,
                       const RenderSettings &settings, const std::vector<double> &frames,
                       const Frame &last) {
    const ordered_json json = {
        {"stage", stage},
        {"device", device_json(renderer.device())},
        {"build",
         {{"options", renderer.options()}, {"milliseconds", renderer.build_milliseconds()}}},
        {"size", {settings.width, settings.height}},
        {"samples", settings.samples},
        {"max_depth", settings.max_depth},
        {"methods", methods_json(stage_number(stage), settings.methods)},
        {"frames", {{"milliseconds", frames}, {"median", median(frames)}}},
        {"rays", rays_json(last.rays)},
        {"dropped_rays", last.rays.dropped},
        {"bytes_on_device", bytes_json(renderer)},
        {"needs", needs_json(renderer.needs())},
    };
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace stagelight
