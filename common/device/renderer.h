// SPDX-License-Identifier: MIT
// From a scene to a picture, with no window: context, queue and samples of one stage's kernel.
#pragma once

#include <map>
#include <string>

#include "device/stage_kernel.h"
#include "image/image.h"

namespace stagelight {

struct Frame {
    Image image;
    RayTotals rays;
    double milliseconds = 0;  // from the first launch to the end of the last
};

class Renderer {
public:
    // Throws as StageKernel does.
    Renderer(const cl::Device &device, const std::string &stage, const Scene &scene,
             const RenderSettings &settings);

    Frame render();

    const cl::Device &device() const { return device_; }
    const RenderSettings &settings() const { return settings_; }
    const StageKernel &stage_kernel() const { return kernel_; }
    // What lies on the device: the kernel's arguments and the picture.
    std::map<std::string, std::size_t> bytes() const;

private:
    double launch(int sample);  // milliseconds

    cl::Device device_;
    RenderSettings settings_;
    cl::Context context_;
    cl::CommandQueue queue_;
    StageKernel kernel_;
    cl::Buffer image_;
    device::DoubleCamera camera_;
};

}  // namespace stagelight
