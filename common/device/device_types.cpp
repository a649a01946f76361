// SPDX-License-Identifier: MIT
#include "device/device_types.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace stagelight {

device::float4 to_float4(const glm::dvec3 &v) {
    return {{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0.0F}};
}

namespace {

device::double4 to_double4(const glm::dvec3 &v) {
    return {{v.x, v.y, v.z, 0.0}};
}

device::float4 rounded(const device::double4 &v) {
    return to_float4(glm::dvec3(v.s[0], v.s[1], v.s[2]));
}

}  // namespace

// #region camera
device::DoubleCamera to_device(const CameraDescription &camera, int width, int height) {
    const glm::dvec3 forward = glm::normalize(camera.look_at - camera.position);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double half_width = std::tan(glm::radians(camera.fov) / 2);
    const double pixel = 2 * half_width / width;  // square
    const glm::dvec3 corner = forward - half_width * right + half_width * height / width * up;
    device::DoubleCamera result = {};
    result.position = to_double4(camera.position);
    result.corner = to_double4(corner);
    result.right = to_double4(pixel * right);
    result.down = to_double4(-pixel * up);
    result.sample = {{0.5, 0.5}};
    result.size = {{width, height}};
    return result;
}
// #endregion camera

device::Camera to_single(const device::DoubleCamera &camera) {
    device::Camera result = {};
    result.media = camera.media;
    result.position = rounded(camera.position);
    result.corner = rounded(camera.corner);
    result.right = rounded(camera.right);
    result.down = rounded(camera.down);
    result.sample = {
        {static_cast<float>(camera.sample.s[0]), static_cast<float>(camera.sample.s[1])}};
    result.size = camera.size;
    return result;
}

namespace {

device::uchar to_device(Wrap wrap) {
    switch (wrap) {
    case Wrap::clamp:
        return device::WRAP_CLAMP;
    case Wrap::mirror:
        return device::WRAP_MIRROR;
    case Wrap::repeat:
        break;
    }
    return device::WRAP_REPEAT;
}

device::ushort2 to_ushort2(std::size_t x, std::size_t y) {
    return {{static_cast<cl_ushort>(x), static_cast<cl_ushort>(y)}};
}

}  // namespace

device::Material to_device(const Material &material, const std::vector<Texture> &textures,
                           const TexturePages &pages) {
    device::Material result = {};
    result.color = to_float4(material.color);
    result.texture = no_texture;
    if (material.texture != no_texture) {
        const auto index = static_cast<std::size_t>(material.texture);
        const Texture &texture = textures[index];
        const TexturePlace &place = pages.places[index];
        result.texture = static_cast<cl_short>(place.layer);
        result.texture_size = to_ushort2(static_cast<std::size_t>(texture.width),
                                         static_cast<std::size_t>(texture.height));
        result.texture_place = to_ushort2(place.x, place.y);
        result.wrap_u = to_device(texture.wrap_u);
        result.wrap_v = to_device(texture.wrap_v);
    }
    switch (material.type) {
    case MaterialType::diffuse:
        result.type = device::MATERIAL_DIFFUSE;
        break;
    case MaterialType::mirror:
        result.type = device::MATERIAL_MIRROR;
        break;
    case MaterialType::glossy:
        result.type = device::MATERIAL_GLOSSY;
        result.as.glossy.specularity = static_cast<float>(material.specularity);
        break;
    case MaterialType::dielectric:
        result.type = device::MATERIAL_DIELECTRIC;
        result.as.dielectric.absorption = to_float4(material.absorption);
        result.as.dielectric.ior = static_cast<float>(material.ior);
        break;
    }
    return result;
}

device::Light to_device(const Light &light) {
    device::Light result = {};
    result.color = to_float4(light.color * light.intensity);
    if (light.type == LightType::point) {
        result.type = device::LIGHT_POINT;
        result.as.point.position = to_float4(light.position);
        result.as.point.range = static_cast<float>(light.range);
    } else {
        result.type = device::LIGHT_DIRECTIONAL;
        result.as.directional.direction = to_float4(light.direction);
    }
    return result;
}

device::Sphere to_device(const Sphere &sphere) {
    return {to_float4(sphere.center), static_cast<float>(sphere.radius), sphere.material};
}

device::Plane to_device(const Plane &plane) {
    return {to_float4(plane.normal), static_cast<float>(glm::dot(plane.normal, plane.point)),
            plane.material};
}

device::Triangle to_device(const Triangle &triangle) {
    return {{triangle.vertices[0], triangle.vertices[1], triangle.vertices[2]}, triangle.material};
}

}  // namespace stagelight
