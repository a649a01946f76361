// SPDX-License-Identifier: MIT
#include "budget/fingerprint.h"

#include <bit>
#include <string_view>

#include <fmt/format.h>

#include "device/kernel_source.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

// FNV-1a (Fowler, Noll and Vo), by which no two files of a user are likely to meet.
class Hash {
public:
    void add(std::string_view bytes) {
        for (const char byte : bytes) {
            value_ = (value_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
        }
        value_ = (value_ ^ bytes.size()) * 0x100000001b3;  // where one ends and the next begins
    }
    void add(std::uint64_t number) { value_ = (value_ ^ number) * 0x100000001b3; }
    void add(int number) { add(static_cast<std::uint64_t>(number)); }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(const glm::dvec3 &v) {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

void add_shapes(Hash &hash, const Scene &scene) {
    for (const Sphere &sphere : scene.spheres) {
        hash.add(sphere.center);
        hash.add(sphere.radius);
        hash.add(sphere.material);
    }
    for (const Plane &plane : scene.planes) {
        hash.add(plane.normal);
        hash.add(plane.point);
        hash.add(plane.material);
    }
    for (const Vertex &vertex : scene.vertices) {
        hash.add(vertex.position);
        hash.add(vertex.normal);
        hash.add(vertex.texture_coordinates.x);
        hash.add(vertex.texture_coordinates.y);
        hash.add(vertex.color);
    }
    for (const Triangle &triangle : scene.triangles) {
        for (const std::uint32_t vertex : triangle.vertices) {
            hash.add(std::uint64_t{vertex});
        }
        hash.add(triangle.material);
    }
}

void add_looks(Hash &hash, const Scene &scene) {
    for (const Material &material : scene.materials) {
        hash.add(static_cast<int>(material.type));
        hash.add(material.color);
        hash.add(material.texture);
        hash.add(material.specularity);
        hash.add(material.ior);
        hash.add(material.absorption);
        hash.add(material.priority);
        hash.add(material.alpha_cutoff);
    }
    for (const Light &light : scene.lights) {
        hash.add(static_cast<int>(light.type));
        hash.add(light.position);
        hash.add(light.direction);
        hash.add(light.color);
        hash.add(light.intensity);
        hash.add(light.range);
    }
    for (const Texture &texture : scene.textures) {
        hash.add(texture.width);
        hash.add(static_cast<int>(texture.wrap_u));
        hash.add(static_cast<int>(texture.wrap_v));
        hash.add(std::string_view(reinterpret_cast<const char *>(texture.texels.data()),
                                  texture.texels.size()));
    }
    hash.add(scene.background);
    hash.add(scene.camera.position);
    hash.add(scene.camera.look_at);
    hash.add(scene.camera.up);
    hash.add(scene.camera.fov);
}

}  // namespace

std::uint64_t fingerprint(const cl::Device &device, const std::string &stage, const Scene &scene,
                          const RenderSettings &settings) {
    Hash hash;
    add_shapes(hash, scene);
    add_looks(hash, scene);
    hash.add(device.getInfo<CL_DEVICE_NAME>());
    hash.add(device.getInfo<CL_DRIVER_VERSION>());
    for (const Method &method : methods_of(stage_number(stage))) {
        for (const std::string &lesson : {stage, stage_name(tree_stage)}) {
            hash.add(kernel_source(fmt::format("stages/{}/kernel.cl", lesson), settings.kernels,
                                   {{method.kind, method.name}}));
        }
    }
    hash.add(settings.width);
    hash.add(settings.height);
    hash.add(settings.max_depth);
    for (const auto &[kind, name] : settings.methods) {
        hash.add(kind);
        hash.add(name);
    }
    return hash.value();
}

}  // namespace stagelight
