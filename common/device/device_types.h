// SPDX-License-Identifier: MIT
// From the scene's description in double to the structs of kernels/scene_types.h.
#pragma once

#include <vector>

#include "device/texture_pages.h"
#include "scene/scene.h"
#include "scene_types.h"

namespace stagelight {

device::float4 to_float4(const glm::dvec3 &v);

// The camera of a picture of width x height pixels, sampled at their centres (docs/shading.md).
device::DoubleCamera to_device(const CameraDescription &camera, int width, int height);
device::Camera to_single(const device::DoubleCamera &camera);

// With `textures` in those places.
device::Material to_device(const Material &material, const std::vector<Texture> &textures,
                           const TexturePages &pages);
device::Light to_device(const Light &light);
device::Sphere to_device(const Sphere &sphere);
device::Plane to_device(const Plane &plane);
device::Triangle to_device(const Triangle &triangle);

}  // namespace stagelight
