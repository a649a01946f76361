// SPDX-License-Identifier: MIT
// --method math=fp64: what the kernels calculate in double is the reference's picture, to the float
// that a picture is stored in.
#include <algorithm>

#include <glm/geometric.hpp>

#include "device/program.h"
#include "render/on_each_device.h"
#include "scene/errors.h"
#include "scene/scene_file.h"

namespace stagelight::render {
namespace {

// The largest distance of a pixel, edges and all, from the reference's.
double worst(const char *stage, const char *file, const Methods &methods) {
    const Scene scene = load_scene(std::string(STAGELIGHT_SOURCE_DIR) + "/scenes/" + file);
    RenderSettings settings = settings_of(scene);
    settings.width = 160;
    settings.height = 96;
    settings.methods = methods;
    const Image picture =
        Renderer(choose_device(implementations.front()), stage, scene, settings).render().image;
    const Image truth = reference::render<double>(scene, {160, 96, scene.max_depth, {}}).image;
    double worst = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const double off = glm::distance(dvec3(picture.pixels[i]), dvec3(truth.pixels[i]));
        worst = std::max(worst, off);
    }
    return worst;
}

bool has_doubles(const char *device) {
    return has_extension(choose_device(device), "cl_khr_fp64");
}

// Spheres between mirrors: what is hit after some bounces hangs on the direction's last digits.
void expect_right(const char *stage) {
    EXPECT_LT(worst(stage, "03_mirrors.toml", {{"math", "fp64"}}), 2e-6);
    EXPECT_GT(worst(stage, "03_mirrors.toml", {}), 1e-5) << "float would have done";
}

TEST(Stage03Double, IsRightToTheFloatOfThePicture) {
    if (!has_doubles(implementations.front())) {
        GTEST_SKIP() << implementations.front() << " has no doubles";
    }
    expect_right("03_reflection_glossy");
}

TEST(Stage11Double, IsRightToTheFloatOfThePicture) {
    if (!has_doubles(implementations.front())) {
        GTEST_SKIP() << implementations.front() << " has no doubles";
    }
    expect_right("11_full_tracer");
    // Rays that are bent five times take what memory has rounded of sphere and glass far.
    const Methods in_glass{{"math", "fp64"},
                           {"depth", "fixed"},
                           {"normalise", "native"},
                           {"transmission", "native_exp"},
                           {"width", "4"}};
    EXPECT_LT(worst("11_full_tracer", "04_interior.toml", in_glass), 4e-4);
    EXPECT_GT(worst("11_full_tracer", "04_interior.toml", {{"depth", "fixed"}}), 4e-4);
}

TEST(Stage11Double, IsNamedWhereTheDeviceLacksIt) {
    const char *without = implementations.back();
    if (asked_device != nullptr && has_doubles(without)) {
        GTEST_SKIP() << without << " has doubles";
    }
    try {
        if (asked_device == nullptr) {
            worst("11_full_tracer", "02_lights.toml", {{"math", "fp64"}});
        }
        const cl::Device device = choose_device(without);
        ASSERT_FALSE(has_doubles(without)) << "it has: this test needs another";
        build_options(device, {}, {{"math", "fp64"}});
        FAIL() << "built for a device without doubles";
    } catch (const MachineError &error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("math=fp64"), std::string::npos) << message;
        EXPECT_NE(message.find("cl_khr_fp64"), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace stagelight::render
