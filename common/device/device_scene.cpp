// SPDX-License-Identifier: MIT
#include "device/device_scene.h"

#include <algorithm>
#include <array>
#include <functional>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/vec3.hpp>

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

// The shapes, in the order of the tree's leaves where there is a tree.
template <typename Shapes, typename Convert>
Bytes pack_shapes(const Shapes &shapes, const Bvh &bvh, const std::vector<std::uint32_t> &order,
                  Convert convert) {
    return bvh.nodes.empty()
               ? pack(shapes, convert)
               : pack(order, [&](std::uint32_t index) { return convert(shapes[index]); });
}

std::array<device::float4, 3> corners_of(const Triangle &triangle, const Scene &scene) {
    std::array<device::float4, 3> corners;
    std::ranges::transform(triangle.vertices, corners.begin(), [&scene](std::uint32_t vertex) {
        return to_float4(scene.vertices[vertex].position);
    });
    return corners;
}

// Media come before the scene's materials, in their order; each is a material of its own, so that
// a surface has no other number to carry.
Bytes pack_materials(const Scene &scene, const Media &media, const TexturePages &pages) {
    std::vector<device::Material> materials;
    for (const int material : media.materials()) {
        materials.push_back(
            to_device(scene.materials[static_cast<std::size_t>(material)], scene.textures, pages));
        materials.back().as.dielectric.medium = 1U << (materials.size() - 1);
    }
    for (const Material &material : scene.materials) {
        materials.push_back(to_device(material, scene.textures, pages));
    }
    return pack(materials, [](const device::Material &material) { return material; });
}

// By texture, whether a triangle's material is cut out by it.
std::vector<bool> cutting_textures(const Scene &scene) {
    std::vector<bool> cutting(scene.textures.size());
    for (const Triangle &triangle : scene.triangles) {
        const Material &material = scene.materials[static_cast<std::size_t>(triangle.material)];
        if (has_cutout(material)) {
            cutting[static_cast<std::size_t>(material.texture)] = true;
        }
    }
    return cutting;
}

// In the order of pack_materials.
Bytes pack_cutouts(const Scene &scene, const Media &media) {
    const std::vector<bool> cutting = cutting_textures(scene);
    std::vector<cl_uint> firsts;
    cl_uint first = 0;
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        firsts.push_back(first);
        first += cutting[i] ? static_cast<cl_uint>(scene.textures[i].texels.size() / 4) : 0;
    }
    std::vector<device::Cutout> cutouts(media.materials().size());
    for (const Material &material : scene.materials) {
        cutouts.push_back({});
        const auto texture = static_cast<std::size_t>(material.texture);
        if (has_cutout(material) && cutting[texture]) {
            cutouts.back() = {firsts[texture], static_cast<float>(255 * material.alpha_cutoff)};
        }
    }
    return pack(cutouts, [](const device::Cutout &cutout) { return cutout; });
}

Bytes pack_alphas(const Scene &scene) {
    const std::vector<bool> cutting = cutting_textures(scene);
    Bytes alphas;
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        for (std::size_t alpha = 3; cutting[i] && alpha < scene.textures[i].texels.size();
             alpha += 4) {
            alphas.push_back(scene.textures[i].texels[alpha]);
        }
    }
    return alphas;
}

// What the host puts behind each name in kernels/scene.cl.
Bytes contents(const std::string &name, const Scene &scene, const Bvh &bvh, const Media &media,
               const TexturePages &pages) {
    const auto with_medium = [&media](const auto &shapes, auto medium_of) {
        return [&media, first = shapes.data(), medium_of](const auto &shape) {
            auto packed = to_device(shape);
            const int medium = (media.*medium_of)(static_cast<std::size_t>(&shape - first));
            packed.material =
                medium < 0 ? packed.material + static_cast<int>(media.materials().size()) : medium;
            return packed;
        };
    };
    if (name == "spheres") {
        return pack_shapes(scene.spheres, bvh, bvh.spheres,
                           with_medium(scene.spheres, &Media::of_sphere));
    }
    if (name == "planes") {
        return pack(scene.planes, with_medium(scene.planes, &Media::of_plane));
    }
    if (name == "lights") {
        return pack(scene.lights, [](const Light &light) { return to_device(light); });
    }
    if (name == "triangles") {
        return pack_shapes(scene.triangles, bvh, bvh.triangles,
                           with_medium(scene.triangles, &Media::of_triangle));
    }
    if (name == "triangle_corners") {
        return pack_shapes(scene.triangles, bvh, bvh.triangles, [&scene](const Triangle &triangle) {
            return corners_of(triangle, scene);
        });
    }
    if (name == "bvh_nodes") {
        return pack(bvh.nodes, [](const device::BvhNode &node) { return node; });
    }
    if (name == "materials") {
        return pack_materials(scene, media, pages);
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
    if (name == "vertex_colors") {
        return pack(scene.vertices, [](const Vertex &v) { return to_float4(v.color); });
    }
    if (name == "cutouts") {
        return pack_cutouts(scene, media);
    }
    if (name == "alphas") {
        return pack_alphas(scene);
    }
    return {};
}

// Of the argument that says how many there are; none for any other.
std::optional<cl_int> count_of(const std::string &name, const Scene &scene) {
    const std::pair<const char *, std::size_t> counts[] = {
        {"sphere_count", scene.spheres.size()},
        {"plane_count", scene.planes.size()},
        {"light_count", scene.lights.size()},
        {"triangle_count", scene.triangles.size()}};
    const auto *found =
        std::ranges::find(counts, name, [](const auto &count) { return count.first; });
    return found == std::end(counts) ? std::nullopt
                                     : std::optional(static_cast<cl_int>(found->second));
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

std::vector<std::string> argument_order(const SceneNeeds &needs, int stage) {
    const auto has = [&needs](const char *name) { return value_of(needs, name) != 0; };
    std::vector<std::string> order{"image"};
    const auto add = [&order](bool is_there, std::initializer_list<const char *> names) {
        if (is_there) {
            order.insert(order.end(), names.begin(), names.end());
        }
    };
    const bool meshes = has("HAS_TRIANGLES");
    const bool tree = has("HAS_TREE");
    add(stage > 1, {"ray_counts"});
    add(true, {"camera"});
    add(has("HAS_SPHERES"), {"spheres", "sphere_count"});
    add(has("HAS_PLANES"), {"planes", "plane_count"});
    add(has("HAS_MATERIALS"), {"materials"});
    add(has("HAS_LIGHTS"), {"lights", "light_count"});
    add(meshes, {"triangles", "triangle_count", "triangle_corners", "vertex_normals"});
    add(tree, {"bvh_nodes"});
    add(has("HAS_MESH_TEXTURES"), {"vertex_texture_coordinates"});
    add(has("HAS_VERTEX_COLORS"), {"vertex_colors"});
    add(has("HAS_CUTOUTS"), {"cutouts", "alphas"});
    add(has("HAS_TEXTURES"), {"textures"});
    add(true, {"background"});
    return order;
}

std::vector<std::string> argument_names(const cl::Kernel &kernel,
                                        const std::vector<std::string> &order) {
    const auto count = kernel.getInfo<CL_KERNEL_NUM_ARGS>();
    std::vector<std::string> names;
    try {
        for (cl_uint i = 0; i < count; ++i) {
            std::string name = kernel.getArgInfo<CL_KERNEL_ARG_NAME>(i);
            name.erase(std::ranges::find(name, '\0'), name.end());  // some count the terminator
            names.push_back(name);
        }
        return names;
    } catch (const cl::Error &error) {
        if (error.err() != CL_KERNEL_ARG_INFO_NOT_AVAILABLE) {
            throw;
        }
    }
    if (order.size() != count) {
        throw DeviceError(
            fmt::format("the driver does not name the kernel's {} arguments, expected "
                        "{}; try another --device (--list-devices)",
                        count, order.size()));
    }
    return order;
}

DeviceScene::DeviceScene(const cl::Context &context, const cl::Device &device, cl::Kernel &kernel,
                         const std::vector<std::string> &names, const Scene &scene, Transfer decode,
                         const Bvh &bvh, const Media &media) {
    const TexturePages pages = pages_of(scene, device);
    for (cl_uint i = 0; i < names.size(); ++i) {
        const std::string &name = names[i];
        if (name == "background") {
            kernel.setArg(i, to_float4(scene.background));
        } else if (const std::optional<cl_int> count = count_of(name, scene)) {
            kernel.setArg(i, *count);
        } else if (name == "textures") {
            textures_.emplace(context, device, scene, decode);
            bytes_[name] = textures_->bytes();
            kernel.setArg(i, textures_->image());
        } else if (Bytes bytes = contents(name, scene, bvh, media, pages); !bytes.empty()) {
            require_room(device, name, bytes.size(), scene);
            bytes_[name] = bytes.size();
            buffers_[name] = cl::Buffer(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
                                        bytes.size(), bytes.data());
            kernel.setArg(i, buffers_[name]);
        } else {
            continue;  // no part of a scene
        }
        set_.insert(name);
    }
}

}  // namespace stagelight
