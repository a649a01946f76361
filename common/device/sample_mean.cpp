// SPDX-License-Identifier: MIT
#include "device/sample_mean.h"

#include "device/kernel_source.h"
#include "device/program.h"

namespace stagelight {

// Hammersley's points (Niederreiter 1992, chapter 3): the first coordinate counts evenly, the
// second in the order of the indices' mirrored bits. Both are in the middle of `count` strata, so
// that each has one sample, and a single one is the pixel's centre.
// #region sample_point
device::double2 sample_point(int index, int count) {
    int before = 0;  // how many indices have less when they are mirrored
    for (int bit = 1; bit <= index; bit *= 2) {
        if ((index & bit) != 0) {  // those with the same bits below it, and 0 here
            before += (count - 1 - index % bit) / (2 * bit) + 1;
        }
    }
    return {{(index + 0.5) / count, (before + 0.5) / count}};
}
// #endregion sample_point

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
