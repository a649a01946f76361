// SPDX-License-Identifier: MIT
#include "device/memory_need.h"

#include <fmt/format.h>

#include "device/scene_needs.h"
#include "device/texture_array.h"
#include "scene/errors.h"
#include "scene_types.h"

namespace stagelight {

std::size_t picture_bytes(const cl::Device &device, int width, int height) {
    const std::size_t bytes =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * sizeof(device::float4);
    const std::size_t largest = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    if (bytes > largest) {
        throw UserError(fmt::format(
            "a picture of {}x{} pixels needs {} bytes; this device takes at most {} at once", width,
            height, bytes, largest));
    }
    return bytes;
}

void require_memory(const cl::Device &device, const Scene &scene, Transfer decode,
                    std::size_t picture, int pictures) {
    const std::size_t vertex = sizeof(device::float4)
                               + (has_textured_mesh(scene) ? sizeof(device::float2) : 0)
                               + (has_vertex_colors(scene) ? sizeof(device::float4) : 0);
    const std::size_t triangle = sizeof(device::Triangle) + 3 * sizeof(device::float4);
    const std::size_t triangles =
        scene.triangles.size() * triangle + scene.vertices.size() * vertex;
    const std::size_t textures = texture_bytes(scene, device, decode);
    const std::size_t all = triangles + textures + static_cast<std::size_t>(pictures) * picture;
    const std::size_t had = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    if (all > had) {
        throw UserError(fmt::format("{}: needs {} bytes on the device, {} of triangles, {} of "
                                    "textures, {} of pictures; this device has {}",
                                    scene.file.string(), all, triangles, textures,
                                    all - triangles - textures, had));
    }
}

}  // namespace stagelight
