// SPDX-License-Identifier: MIT
#include "device/device_scene.h"

#include <algorithm>
#include <functional>
#include <vector>

#include <fmt/format.h>

#include "device/device_types.h"
#include "scene/errors.h"

namespace stagelight {
namespace {

using Bytes = std::vector<unsigned char>;

// The elements, each through `convert`, as the bytes of a buffer.
template <typename Elements, typename Convert>
Bytes pack(const Elements &elements, Convert convert) {
    using Packed = std::invoke_result_t<Convert, const typename Elements::value_type &>;
    Bytes bytes(elements.size() * sizeof(Packed));
    auto *out = bytes.data();
    for (const auto &element : elements) {
        const Packed packed = convert(element);
        std::memcpy(out, &packed, sizeof packed);
        out += sizeof packed;
    }
    return bytes;
}

// Rounded to float as the vertices are, and then subtracted: as kernels/triangle.cl does.
device::Facet facet_of(const Scene &scene, std::uint32_t index) {
    const auto &vertices = scene.triangles[index].vertices;
    const auto corner = [&](std::size_t i) {
        return glm::vec3(scene.vertices[vertices[i]].position);
    };
    const glm::vec3 a = corner(0);
    const glm::vec3 b = corner(1) - a;
    const glm::vec3 c = corner(2) - a;
    return {{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}};
}

// What the host puts behind each name in kernels/scene.cl.
Bytes contents(const std::string &name, const Scene &scene, const Bvh &bvh) {
    const auto convert = [](const auto &element) { return to_device(element); };
    if (name == "spheres") {
        return pack(scene.spheres, convert);
    }
    if (name == "planes") {
        return pack(scene.planes, convert);
    }
    if (name == "lights") {
        return pack(scene.lights, convert);
    }
    if (name == "triangles" && bvh.order.empty()) {
        return pack(scene.triangles, convert);
    }
    if (name == "triangles") {
        return pack(bvh.order,
                    [&scene](std::uint32_t index) { return to_device(scene.triangles[index]); });
    }
    if (name == "facets") {
        return pack(bvh.order, [&scene](std::uint32_t index) { return facet_of(scene, index); });
    }
    if (name == "bvh_nodes") {
        return pack(bvh.nodes, [](std::uint32_t word) { return word; });
    }
    if (name == "materials") {
        return pack(scene.materials, [&scene](const Material &material) {
            return to_device(material, scene.textures);
        });
    }
    if (name == "vertex_positions") {
        return pack(scene.vertices, [](const Vertex &v) { return to_float4(v.position); });
    }
    if (name == "vertex_normals") {
        return pack(scene.vertices, [](const Vertex &v) { return to_float4(v.normal); });
    }
    if (name == "vertex_texture_coordinates") {
        return pack(scene.vertices, [](const Vertex &v) {
            return device::float2{{static_cast<float>(v.texture_coordinates.x),
                                   static_cast<float>(v.texture_coordinates.y)}};
        });
    }
    return {};
}

void require_room(const cl::Device &device, const std::string &name, std::size_t bytes,
                  const Scene &scene) {
    const std::size_t largest = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    if (bytes > largest) {
        throw UserError(
            fmt::format("{}: its {} need {} bytes; this device takes at most {} at once",
                        scene.file.string(), name, bytes, largest));
    }
}

}  // namespace

std::vector<std::string> argument_names(const cl::Kernel &kernel) {
    std::vector<std::string> names;
    for (cl_uint i = 0; i < kernel.getInfo<CL_KERNEL_NUM_ARGS>(); ++i) {
        std::string name = kernel.getArgInfo<CL_KERNEL_ARG_NAME>(i);
        name.erase(std::ranges::find(name, '\0'), name.end());  // some drivers count the terminator
        names.push_back(name);
    }
    return names;
}

DeviceScene::DeviceScene(const cl::Context &context, const cl::Device &device, cl::Kernel &kernel,
                         const Scene &scene, Transfer decode, const Bvh &bvh) {
    const std::vector<std::string> names = argument_names(kernel);
    for (cl_uint i = 0; i < names.size(); ++i) {
        const std::string &name = names[i];
        if (name == "background") {
            kernel.setArg(i, to_float4(scene.background));
        } else if (name == "textures") {
            textures_.emplace(context, device, scene, decode);
            bytes_[name] = textures_->bytes();
            kernel.setArg(i, textures_->image());
        } else if (Bytes bytes = contents(name, scene, bvh); !bytes.empty()) {
            require_room(device, name, bytes.size(), scene);
            bytes_[name] = bytes.size();
            buffers_[name] = cl::Buffer(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
                                        bytes.size(), bytes.data());
            kernel.setArg(i, buffers_[name]);
        }
    }
}

}  // namespace stagelight
