// SPDX-License-Identifier: MIT
#include "device/renderer.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include <fmt/format.h>
#include <glm/vec4.hpp>

#include "device/device_types.h"
#include "device/kernel_source.h"
#include "scene/errors.h"
#include "scene/lessons.h"

namespace stagelight {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Hammersley's points (Niederreiter 1992, chapter 3): the first coordinate counts evenly, the
// second mirrors the index's bits. Moved to the middle of their strata, so that a single
// sample is the pixel's centre.
device::float2 sample_point(int index, int count) {
    double radical_inverse = 0;
    double digit = 0.5;
    int strata = 1;
    for (int bits = index; bits > 0; bits /= 2, digit /= 2) {
        radical_inverse += (bits % 2) * digit;
    }
    while (strata < count) {
        strata *= 2;
    }
    return {{static_cast<float>((index + 0.5) / count),
             static_cast<float>(radical_inverse + 0.5 / strata)}};
}

std::size_t round_up(int size, std::size_t multiple) {
    return (static_cast<std::size_t>(size) + multiple - 1) / multiple * multiple;
}

std::size_t pixel_count(const RenderSettings &settings) {
    return static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
}

void require_picture_fits(const cl::Device &device, const RenderSettings &settings) {
    const std::size_t bytes = pixel_count(settings) * sizeof(device::float4);
    const std::size_t largest = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    if (bytes > largest) {
        throw UserError(fmt::format(
            "a picture of {}x{} pixels needs {} bytes; this device takes at most {} at once",
            settings.width, settings.height, bytes, largest));
    }
}

}  // namespace

std::string build_options(const SceneNeeds &needs, const Methods &methods) {
    std::string options = "-cl-std=CL1.2 -cl-kernel-arg-info";
    for (const auto &[name, value] : needs) {
        options += fmt::format(" -D {}={}", name, value);
    }
    for (const std::string &define : defines_of(methods)) {
        options += fmt::format(" -D {}=1", define);
    }
    return options;
}

cl::Program build_program(const cl::Context &context, const std::string &source,
                          const std::string &options, bool from_disk) {
    cl::Program program(context, source);
    try {
        program.build(options.c_str());
    } catch (const cl::BuildError &error) {
        std::string message = "the kernel does not build:";
        for (const auto &[device, log] : error.getBuildLog()) {
            message += '\n' + log;
        }
        if (from_disk) {
            throw KernelError(message);
        }
        throw MachineError(message);
    }
    return program;
}

Renderer::Renderer(const cl::Device &device, const std::string &stage, const Scene &scene,
                   const RenderSettings &settings)
    : device_(device), settings_(settings),
      needs_(needs_of(scene, stage_number(stage), settings.max_depth)),
      options_(build_options(needs_, settings.methods)), context_(device), queue_(context_, device),
      camera_(to_device(scene.camera, settings.width, settings.height)) {
    require_picture_fits(device, settings);
    const std::string source = kernel_source("stages/" + stage + "/kernel.cl", settings.kernels);
    const Clock::time_point start = Clock::now();
    kernel_ = cl::Kernel(build_program(context_, source, options_, settings.kernels.has_value()),
                         "render");
    build_milliseconds_ = milliseconds_since(start);
    scene_.emplace(context_, device, kernel_, scene,
                   decode_of(stage_number(stage), settings.methods));

    const std::vector<std::string> names = argument_names(kernel_);
    for (cl_uint i = 0; i < names.size(); ++i) {
        arguments_[names[i]] = i;
    }
    for (const char *name : {"image", "camera"}) {
        if (!arguments_.contains(name)) {
            throw KernelError(fmt::format("the kernel 'render' has no argument '{}'", name));
        }
    }
    image_ =
        cl::Buffer(context_, CL_MEM_WRITE_ONLY, pixel_count(settings) * sizeof(device::float4));
    kernel_.setArg(arguments_.at("image"), image_);
    if (arguments_.contains("ray_counts")) {
        ray_counts_ =
            cl::Buffer(context_, CL_MEM_READ_WRITE,
                       static_cast<std::size_t>(settings.height) * sizeof(device::RayCounts));
        kernel_.setArg(arguments_.at("ray_counts"), *ray_counts_);
    }
}

std::map<std::string, std::size_t> Renderer::bytes() const {
    std::map<std::string, std::size_t> bytes = scene_->bytes();
    bytes["image"] = image_.getInfo<CL_MEM_SIZE>();
    if (ray_counts_) {
        bytes["ray_counts"] = ray_counts_->getInfo<CL_MEM_SIZE>();
    }
    return bytes;
}

double Renderer::launch(device::float2 sample) {
    constexpr std::size_t group_width = 8;
    constexpr std::size_t group_height = 8;
    camera_.sample = sample;
    kernel_.setArg(arguments_.at("camera"), camera_);
    if (ray_counts_) {
        queue_.enqueueFillBuffer(*ray_counts_, cl_uint{0}, 0, ray_counts_->getInfo<CL_MEM_SIZE>());
    }
    queue_.finish();
    const Clock::time_point start = Clock::now();
    queue_.enqueueNDRangeKernel(kernel_, cl::NullRange,
                                cl::NDRange(round_up(settings_.width, group_width),
                                            round_up(settings_.height, group_height)),
                                cl::NDRange(group_width, group_height));
    queue_.finish();
    return milliseconds_since(start);
}

void Renderer::add_ray_counts(RayTotals &totals) {
    totals.primary += pixel_count(settings_);
    if (!ray_counts_) {
        return;
    }
    std::vector<device::RayCounts> rows(static_cast<std::size_t>(settings_.height));
    queue_.enqueueReadBuffer(*ray_counts_, CL_TRUE, 0, rows.size() * sizeof rows[0], rows.data());
    for (const device::RayCounts &row : rows) {
        totals.shadow += row.shadow;
        totals.reflection += row.reflection;
        totals.refraction += row.refraction;
        totals.dropped += row.dropped;
    }
}

Frame Renderer::render() {
    Frame frame;
    frame.image = Image(settings_.width, settings_.height);
    std::vector<glm::vec4> pixels(pixel_count(settings_));
    for (int i = 0; i < settings_.samples; ++i) {
        frame.milliseconds += launch(sample_point(i, settings_.samples));
        add_ray_counts(frame.rays);
        queue_.enqueueReadBuffer(image_, CL_TRUE, 0, pixels.size() * sizeof pixels[0],
                                 pixels.data());
        std::ranges::transform(
            pixels, frame.image.pixels, frame.image.pixels.begin(),
            [](const glm::vec4 &pixel, const glm::vec3 &sum) { return sum + glm::vec3(pixel); });
    }
    if (settings_.samples > 1) {
        for (glm::vec3 &pixel : frame.image.pixels) {
            pixel /= static_cast<float>(settings_.samples);
        }
    }
    return frame;
}

}  // namespace stagelight
