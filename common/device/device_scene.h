// SPDX-License-Identifier: MIT
// A scene on a device: a buffer for each argument that the kernel has, and no other.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "device/bvh.h"
#include "device/media.h"
#include "device/methods.h"
#include "device/opencl.h"
#include "device/scene_needs.h"
#include "device/texture_array.h"
#include "scene/scene.h"

namespace stagelight {

class DeviceScene {
public:
    // Sets every argument of `kernel` that is part of the scene (kernels/scene.cl); `names` are
    // those of its arguments, in order. Texels are decoded by `decode`; triangles lie in the order
    // of `bvh` if it has any, and materials after those of `media`. Throws as TextureArray does.
    DeviceScene(const cl::Context &context, const cl::Device &device, cl::Kernel &kernel,
                const std::vector<std::string> &names, const Scene &scene,
                Transfer decode = Transfer::none, const Bvh &bvh = {}, const Media &media = {});

    // Whether that argument of the kernel is part of the scene, and was set.
    bool has_set(const std::string &name) const { return set_.contains(name); }
    // The argument `textures`, where the scene has any.
    const std::optional<TextureArray> &textures() const { return textures_; }
    // What lies on the device, by argument.
    const std::map<std::string, std::size_t> &bytes() const { return bytes_; }

private:
    std::map<std::string, cl::Buffer> buffers_;
    std::optional<TextureArray> textures_;
    std::map<std::string, std::size_t> bytes_;
    std::set<std::string> set_;
};

// The arguments of `stage`'s kernel for such needs, as the kernels declare them.
std::vector<std::string> argument_order(const SceneNeeds &needs, int stage);

// The names of a kernel's arguments, in order (it was built with -cl-kernel-arg-info). Of a driver
// that keeps no names, `order`; throws DeviceError where the kernel has more arguments or fewer.
std::vector<std::string> argument_names(const cl::Kernel &kernel,
                                        const std::vector<std::string> &order = {});

}  // namespace stagelight
