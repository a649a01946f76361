// SPDX-License-Identifier: MIT
// From a scene to a picture: context, program, buffers and launches of one stage's kernel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "device/device_scene.h"
#include "device/methods.h"
#include "device/opencl.h"
#include "device/scene_needs.h"
#include "image/image.h"
#include "scene/scene.h"
#include "scene_types.h"

namespace stagelight {

struct RenderSettings {
    int width = 640;
    int height = 384;
    int max_depth = 8;
    int samples = 1;  // a pixel
    Methods methods;
    std::optional<std::filesystem::path> kernels;  // a checkout to read the kernels from
};

// Summed over all samples of a picture.
struct RayTotals {
    std::uint64_t primary = 0;
    std::uint64_t shadow = 0;
    std::uint64_t reflection = 0;
    std::uint64_t refraction = 0;
    std::uint64_t dropped = 0;  // cut off by the depth limit
};

struct Frame {
    Image image;
    RayTotals rays;
    double milliseconds = 0;  // from the first launch to the end of the last
};

// -cl-std and the names that kernels/ are built with for a scene and its methods.
std::string build_options(const SceneNeeds &needs, const Methods &methods);

// Builds `source`. Where it does not build, throws the log: as a KernelError if it was read
// `from_disk` (the user's own work), else as a MachineError.
cl::Program build_program(const cl::Context &context, const std::string &source,
                          const std::string &options, bool from_disk = false);

class Renderer {
public:
    // `stage` is its folder's name, "04_refraction_beer". Throws as build_program and
    // DeviceScene do, and UserError for a picture that is more than the device takes.
    Renderer(const cl::Device &device, const std::string &stage, const Scene &scene,
             const RenderSettings &settings);

    Frame render();

    const cl::Device &device() const { return device_; }
    const cl::Kernel &kernel() const { return kernel_; }
    const SceneNeeds &needs() const { return needs_; }
    const std::string &options() const { return options_; }
    double build_milliseconds() const { return build_milliseconds_; }
    std::map<std::string, std::size_t> bytes() const;

private:
    double launch(device::float2 sample);  // milliseconds
    void add_ray_counts(RayTotals &totals);

    cl::Device device_;
    RenderSettings settings_;
    SceneNeeds needs_;
    std::string options_;
    cl::Context context_;
    cl::CommandQueue queue_;
    cl::Kernel kernel_;
    std::optional<DeviceScene> scene_;
    std::map<std::string, cl_uint> arguments_;
    device::Camera camera_;
    cl::Buffer image_;
    std::optional<cl::Buffer> ray_counts_;
    double build_milliseconds_ = 0;
};

}  // namespace stagelight
