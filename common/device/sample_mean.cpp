// SPDX-License-Identifier: MIT
#include "device/sample_mean.h"

#include "device/kernel_source.h"
#include "device/stage_kernel.h"

namespace stagelight {

SampleMean::SampleMean(const cl::Context &context, const std::string &options,
                       const std::optional<std::filesystem::path> &kernels)
    : context_(context),
      kernel_(build_program(context, kernel_source("kernels/accumulate.cl", kernels), options,
                            named_kernels(kernels).has_value()),
              "accumulate") {}

const cl::Buffer &SampleMean::sample(const device::int2 &size) {
    const auto [width, height] = size.s;
    if (width != size_.s[0] || height != size_.s[1]) {
        const std::size_t bytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height)
                                  * sizeof(device::float4);
        sample_ = cl::Buffer(context_, CL_MEM_READ_WRITE, bytes);
        sum_ = cl::Buffer(context_, CL_MEM_READ_WRITE, bytes);
        size_ = size;
    }
    return sample_;
}

void SampleMean::add(const cl::CommandQueue &queue, const cl::Memory &picture, int before) {
    kernel_.setArg(0, picture);
    kernel_.setArg(1, sample_);
    kernel_.setArg(2, sum_);
    kernel_.setArg(3, before);
    queue.enqueueNDRangeKernel(
        kernel_, cl::NullRange,
        cl::NDRange(static_cast<std::size_t>(size_.s[0]), static_cast<std::size_t>(size_.s[1])));
}

std::map<std::string, std::size_t> SampleMean::bytes() const {
    const std::size_t bytes = static_cast<std::size_t>(size_.s[0])
                              * static_cast<std::size_t>(size_.s[1]) * sizeof(device::float4);
    return {{"sample", bytes}, {"sample_sum", bytes}};
}

}  // namespace stagelight
