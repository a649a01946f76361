// SPDX-License-Identifier: MIT
// More than a device takes is told with both numbers, before any of it is allocated.
#include <fmt/format.h>

#include "render/on_each_device.h"
#include "scene/messages.h"

namespace stagelight::render {
namespace {

class Stage06Limits : public OnEachDevice {
protected:
    static void expect_refused(const Scene &scene, const RenderSettings &settings,
                               std::size_t needed, std::size_t most) {
        const std::string message = message_of([&] { renderer("06_textures", scene, settings); });
        for (const std::size_t number : {needed, most}) {
            EXPECT_NE(message.find(std::to_string(number)), std::string::npos)
                << "expected a message with " << number << ", found: " << message;
        }
    }
    // A ball with textures of this size, whose texels nobody is to ask for.
    static Scene textured(std::size_t count, std::size_t width, std::size_t height) {
        Scene scene = one_pixel({0, 0, 3}, {0, 0, 0});
        scene.textures.resize(count, texture_of(int(width), int(height), {}));
        Material material = diffuse({1, 1, 1});
        material.texture = 0;
        add_sphere(scene, {0, 0, 0}, 1, material);
        return scene;
    }
};
INSTANTIATE_TEST_SUITE_P(Devices, Stage06Limits, each_device(), device_name);

TEST_P(Stage06Limits, OfATexture) {
    const cl::Device device = choose_device(GetParam());
    const std::size_t widest = device.getInfo<CL_DEVICE_IMAGE2D_MAX_WIDTH>() - 2;
    const Scene wide = textured(1, widest + 1, 1);
    expect_refused(wide, settings_of(wide), widest + 1, widest);
    const std::size_t highest = device.getInfo<CL_DEVICE_IMAGE2D_MAX_HEIGHT>() - 2;
    const Scene high = textured(1, 1, highest + 1);
    expect_refused(high, settings_of(high), highest + 1, highest);
}

TEST_P(Stage06Limits, OfAllTexturesTogether) {
    const std::size_t most = choose_device(GetParam()).getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    const std::size_t each = 4096 * 4096 * 4;
    const std::size_t count = most / each + 1;
    const Scene scene = textured(count, 4094, 4094);
    expect_refused(scene, settings_of(scene), count * each, most);
}

TEST_P(Stage06Limits, OfThePicture) {
    const std::size_t most = choose_device(GetParam()).getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    Scene scene = textured(1, 1, 1);
    RenderSettings settings = settings_of(scene);
    settings.width = 65536;
    settings.height = int(most / 16 / 65536 + 1);
    expect_refused(scene, settings, std::size_t(65536) * std::size_t(settings.height) * 16, most);
}

// Each of them within its limits, and all together beyond the device's memory.
TEST_P(Stage06Limits, OfAllTogether) {
    const cl::Device device = choose_device(GetParam());
    const std::size_t most = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    const std::size_t had = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    const std::size_t each = 4096 * 4096 * 4;
    const std::size_t count = most / each / 2;
    const Scene scene = textured(count, 4094, 4094);
    RenderSettings settings = settings_of(scene);
    settings.samples = 2;
    settings.width = 65536;
    settings.height = int(most / 16 / 65536);
    const std::size_t pictures =
        3 * std::size_t(settings.width) * std::size_t(settings.height) * 16;
    if (count * each + pictures <= had) {
        GTEST_SKIP() << "all that this device takes at once is less than its memory";
    }
    expect_refused(scene, settings, count * each + pictures, had);
}

}  // namespace
}  // namespace stagelight::render
