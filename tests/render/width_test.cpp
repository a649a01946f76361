// SPDX-License-Identifier: MIT
// How many rays a work-item traces side by side: what the device prefers, unless somebody says it.
#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

class Stage10Width : public OnEachDevice {
protected:
    static int width_of(const Methods &methods, bool split = false) {
        Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
        add_sphere(scene, {0, 0, 0}, 1, diffuse({1, 1, 1}));
        RenderSettings settings = settings_of(scene);
        settings.methods = methods;
        settings.split = split;
        return value_of(renderer("10_packets", scene, settings).stage_kernel().needs(), "WIDTH");
    }
};
INSTANTIATE_TEST_SUITE_P(Devices, Stage10Width, each_device(), device_name);

// A picture shows nothing of it: only the time would.
TEST_P(Stage10Width, IsWhatTheDevicePrefers) {
    const cl::Device device = choose_device(GetParam());
    const auto expected = [&](cl_uint preferred) {
        const int widths[] = {1, 4, 8, 16};
        int width = 1;
        for (const int each : widths) {
            width = cl_uint(each) <= preferred ? each : width;
        }
        return is_gpu(device) ? 1 : width;
    };
    EXPECT_EQ(width_of({}), expected(device.getInfo<CL_DEVICE_PREFERRED_VECTOR_WIDTH_FLOAT>()));
    if (device.getInfo<CL_DEVICE_EXTENSIONS>().find("cl_khr_fp64") != std::string::npos) {
        EXPECT_EQ(width_of({{"math", "fp64"}}),
                  expected(device.getInfo<CL_DEVICE_PREFERRED_VECTOR_WIDTH_DOUBLE>()));
    }
}

TEST_P(Stage10Width, IsWhatWasChosen) {
    EXPECT_EQ(width_of({{"width", "1"}}), 1);
    EXPECT_EQ(width_of({{"width", "4"}}), 4);
    EXPECT_EQ(width_of({{"width", "4"}}, true), 1) << "a split runs through tiles";
}

}  // namespace
}  // namespace stagelight::render
