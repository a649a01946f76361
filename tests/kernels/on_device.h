// SPDX-License-Identifier: MIT
// The functions of kernels/, called through small kernels on each OpenCL device that the
// packages bring.
#pragma once

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include "device/device_choice.h"
#include "device/device_scene.h"
#include "device/opencl.h"
#include "device/renderer.h"
#include "implementations.h"

namespace stagelight {

// One file of tests/kernels, built for one device as a stage's kernel is. The arguments of its
// kernels are the results, the inputs, one of each for a work-item, and then the scene if any.
class DeviceProgram {
public:
    DeviceProgram(const cl::Device &device, const std::string &file, const SceneNeeds &needs,
                  const Methods &methods, Transfer decode = Transfer::none);

    template <typename Result, typename... Input>
    std::vector<Result> run(const char *kernel, const std::vector<Input> &...inputs) {
        return launch<Result>(cl::Kernel(program_, kernel), inputs...);
    }

    template <typename Result, typename... Input>
    std::vector<Result> run_in(const Scene &scene, const char *name,
                               const std::vector<Input> &...inputs) {
        cl::Kernel kernel(program_, name);
        const DeviceScene on_device(context_, device_, kernel, argument_names(kernel), scene,
                                    decode_);
        return launch<Result>(kernel, inputs...);
    }

private:
    template <typename Result, typename... Input>
    std::vector<Result> launch(cl::Kernel kernel, const std::vector<Input> &...inputs) {
        const std::size_t count = std::max({inputs.size()...});
        if (((inputs.size() != count) || ...)) {
            throw std::logic_error("inputs of different lengths");
        }
        // Whole groups of one size: PoCL builds a kernel anew for each other size.
        const std::size_t group =
            std::min<std::size_t>(64, kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device_));
        const std::size_t items = (count + group - 1) / group * group;
        std::vector<Result> results(items);
        const std::array<cl::Buffer, 1 + sizeof...(inputs)> buffers{upload(results, items),
                                                                    upload(inputs, items)...};
        for (cl_uint i = 0; i < buffers.size(); ++i) {
            kernel.setArg(i, buffers[i]);
        }
        queue_.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(items), cl::NDRange(group));
        queue_.enqueueReadBuffer(buffers[0], CL_TRUE, 0, items * sizeof(Result), results.data());
        results.resize(count);
        return results;
    }

    template <typename Element>
    cl::Buffer upload(std::vector<Element> elements, std::size_t items) const {
        elements.resize(items);
        return {context_, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, items * sizeof(Element),
                elements.data()};
    }

    cl::Device device_;
    cl::Context context_;
    cl::CommandQueue queue_;
    cl::Program program_;
    Transfer decode_;
};

// A test that runs on each device, by its platform's name.
class OnDevice : public testing::TestWithParam<const char *> {
protected:
    static DeviceProgram build(const std::string &file, const SceneNeeds &needs = {},
                               const Methods &methods = {}, Transfer decode = Transfer::none) {
        return {device(), file, needs, methods, decode};
    }
    static cl::Device device() { return choose_device(GetParam()); }
    static bool on_rusticl() { return is_rusticl(GetParam()); }
};

inline auto each_device() {
    return testing::ValuesIn(implementations);
}

inline std::string device_name(const testing::TestParamInfo<const char *> &info) {
    return name_in_tests(info.param);
}

}  // namespace stagelight
