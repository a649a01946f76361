// SPDX-License-Identifier: MIT
#include "golden/filter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "device/device_scene.h"
#include "device/kernel_source.h"
#include "device/program.h"

namespace stagelight::golden {
namespace {

// Black on the left, white on the right.
Scene scene_of_two_texels() {
    Scene scene;
    scene.textures.push_back({.file = "black and white",
                              .width = 2,
                              .height = 1,
                              .texels = {0, 0, 0, 255, 255, 255, 255, 255},
                              .where = {}});
    scene.materials.push_back({.texture = 0, .where = {}});
    return scene;
}

}  // namespace

double filter_error(const cl::Device &device, Transfer decode) {
    constexpr std::size_t count = 4096;
    const Scene scene = scene_of_two_texels();
    std::vector<device::float4> places(count);  // u, v and a material
    for (std::size_t i = 0; i < count; ++i) {   // from the middle of one texel to the other's
        places[i] = {{0.25F + 0.5F * static_cast<float>(i) / count, 0.5F, 0, 0}};
    }
    const cl::Context context(device);
    const cl::CommandQueue queue(context, device);
    const cl::Program program =
        build_program(context, kernel_source("tests/kernels/texture.cl"),
                      build_options(device, {{"HAS_MATERIALS", 1}, {"HAS_TEXTURES", 1}}, {}));
    cl::Kernel kernel(program, "colors");
    const DeviceScene on_device(context, device, kernel, argument_names(kernel), scene, decode);
    const std::size_t bytes = count * sizeof places[0];
    const cl::Buffer results(context, CL_MEM_WRITE_ONLY, bytes);
    const cl::Buffer input(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, bytes, places.data());
    kernel.setArg(0, results);
    kernel.setArg(1, input);
    queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(count));
    std::vector<device::float4> colors(count);
    queue.enqueueReadBuffer(results, CL_TRUE, 0, bytes, colors.data());
    double worst = 0;
    for (std::size_t i = 0; i < count; ++i) {
        worst = std::max(worst, std::abs(colors[i].s[0] - 2.0 * (places[i].s[0] - 0.25)));
    }
    return worst;
}

}  // namespace stagelight::golden
