// SPDX-License-Identifier: MIT
// A picture of many samples is their mean.
#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

class Stage01SampleMean : public OnEachDevice {
protected:
    static Image draw_samples(const Scene &scene, int samples) {
        RenderSettings settings = settings_of(scene);
        settings.samples = samples;
        return renderer("01_primitives", scene, settings).render().image;
    }
};
INSTANTIATE_TEST_SUITE_P(Devices, Stage01SampleMean, each_device(), device_name);

// Seven times a quarter, divided by seven, is a quarter in floats too.
TEST_P(Stage01SampleMean, OfOneColourIsThatColour) {
    Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
    scene.background = {0.25, 0.5, 2};
    for (const int samples : {1, 2, 7, 64}) {
        EXPECT_EQ(draw_samples(scene, samples).at(0, 0), glm::vec3(0.25F, 0.5F, 2)) << samples;
    }
}

}  // namespace
}  // namespace stagelight::render
