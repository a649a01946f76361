// SPDX-License-Identifier: MIT
// Pictures of a stage's kernel, drawn on two OpenCL implementations that share no compiler.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "device/device_choice.h"
#include "device/renderer.h"
#include "implementations.h"
#include "reference/scenes.h"
#include "scene/scene.h"

namespace stagelight::render {

using namespace reference;  // its small scenes

// Of a scene that says its own size and depth.
inline RenderSettings settings_of(const Scene &scene) {
    RenderSettings settings;
    settings.width = scene.width;
    settings.height = scene.height;
    settings.max_depth = scene.max_depth;
    return settings;
}

class OnEachDevice : public testing::TestWithParam<const char *> {
protected:
    static Renderer renderer(const char *stage, const Scene &scene,
                             const RenderSettings &settings) {
        return {choose_device(GetParam()), stage, scene, settings};
    }
    static Renderer renderer(const char *stage, const Scene &scene) {
        return renderer(stage, scene, settings_of(scene));
    }
    static Frame draw(const char *stage, const Scene &scene) {
        return renderer(stage, scene).render();
    }
};

inline auto each_device() {
    return testing::ValuesIn(implementations);
}

inline std::string device_name(const testing::TestParamInfo<const char *> &info) {
    return name_in_tests(info.param);
}

// An empty scene of one pixel, that looks from `position` to `look_at`.
inline Scene one_pixel(dvec3 position, dvec3 look_at) {
    Scene scene;
    scene.width = scene.height = 1;
    scene.camera.position = position;
    scene.camera.look_at = look_at;
    return scene;
}

// Float arithmetic of a few dozen steps.
constexpr double few_roundings = 1e-5;

// Within `tolerance` of the expected colour, relative where that is above 1.
inline void expect_color(const Image &image, int x, int y, dvec3 expected,
                         double tolerance = few_roundings,
                         std::source_location at = std::source_location::current()) {
    SCOPED_TRACE("pixel (" + std::to_string(x) + ", " + std::to_string(y) + ")");
    expect_near(dvec3(image.at(x, y)), expected, tolerance * std::max(1.0, glm::length(expected)),
                at);
}

}  // namespace stagelight::render
