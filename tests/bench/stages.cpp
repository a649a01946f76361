// SPDX-License-Identifier: MIT
#include "bench/stages.h"

#include "device/scene_needs.h"
#include "golden/suite.h"
#include "scene/progress.h"
#include "scene/stages.h"

namespace stagelight::bench {

const std::string &full_tracer() {
    return stage_names().back();
}

RenderSettings settings_of(const std::string &stage, const Scene &scene, const Methods &methods) {
    RenderSettings settings;
    settings.width = scene.width;
    settings.height = scene.height;
    settings.max_depth = depth_of(scene, stage_number(stage));
    settings.methods = methods;
    return settings;
}

reference::Result reference_of(const std::string &stage, const Scene &scene,
                               const RenderSettings &settings) {
    reference::Settings same = golden::reference_settings(stage, scene, settings.methods);
    same.width = settings.width;
    same.height = settings.height;
    same.max_depth = settings.max_depth;
    const Progress progress("drawing the reference");
    return reference::render<double>(scene, same, golden::shown_by(stage));
}

}  // namespace stagelight::bench
