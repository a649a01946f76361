// SPDX-License-Identifier: MIT
#include "bench/stages.h"

#include "device/kernel_source.h"
#include "scene/lessons.h"

namespace stagelight::bench {

std::vector<std::string> stages() {
    std::vector<std::string> names;
    for (const std::string_view name : stage_names) {
        if (embedded_sources.contains("stages/" + std::string(name) + "/kernel.cl")) {
            names.emplace_back(name);
        }
    }
    return names;
}

std::string full_tracer() {
    return stages().back();
}

RenderSettings settings_of(const Scene &scene) {
    RenderSettings settings;
    settings.width = scene.width;
    settings.height = scene.height;
    settings.max_depth = scene.max_depth;
    return settings;
}

reference::Result reference_of(const std::string &stage, const Scene &scene) {
    const int number = stage_number(stage);
    return reference::render<double>(scene,
                                     {.width = scene.width,
                                      .height = scene.height,
                                      .max_depth = scene.max_depth,
                                      .decode = decode_of(number, {})},
                                     number == 1 ? reference::Shown::normals_and_distances
                                                 : reference::Shown::light);
}

}  // namespace stagelight::bench
