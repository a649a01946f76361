// SPDX-License-Identifier: MIT
// Samples of a picture: where they go through a pixel, and their mean, on the device as they come.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "device/opencl.h"
#include "scene_types.h"

namespace stagelight {

// The point of a pixel, in [0, 1), that the sample `index` of `count` goes through.
device::double2 sample_point(int index, int count);

class SampleMean {
public:
    // `options` are those that a kernel is built with which writes to the picture; `kernels` is a
    // checkout to read from. Throws as build_program does.
    SampleMean(const cl::Context &context, const std::string &options,
               const std::optional<std::filesystem::path> &kernels);

    // Where to put the next sample of a picture of `size` pixels.
    const cl::Buffer &sample(const device::int2 &size);
    // Writes the mean of that sample and the `before` ones added earlier to `picture`. In-order,
    // and without waiting.
    void add(const cl::CommandQueue &queue, const cl::Memory &picture, int before);

    // What lies on the device, by name.
    std::map<std::string, std::size_t> bytes() const;

private:
    cl::Context context_;
    cl::Kernel kernel_;
    device::int2 size_{};
    cl::Buffer sample_;
    cl::Buffer sum_;  // in float, whatever the picture holds
};

}  // namespace stagelight
