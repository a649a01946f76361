// SPDX-License-Identifier: MIT
// Introduced by stage 01: the ray that a pixel sees along.
#include "ray.cl"

// #region camera_ray
static Ray camera_ray(const Camera *camera, const int2 pixel) {
    const float2 point = convert_float2(pixel) + camera->sample;
    const float4 direction = camera->corner + point.x * camera->right + point.y * camera->down;
    const Ray ray = {camera->position.xyz, unit(direction.xyz)};
    return ray;
}
// #endregion camera_ray
