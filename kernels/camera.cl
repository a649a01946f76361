// SPDX-License-Identifier: MIT
// Introduced by stage 01: the ray that a pixel sees along.
#include "ray.cl"

// #region camera_ray
static Ray camera_ray(const Camera *camera, const int2 pixel) {
    const float2 point = JOIN(TO_REAL, 2)(pixel) + XY(camera->sample);
    const float3 direction = XYZ(camera->corner) + point.x * XYZ(camera->right) + point.y * XYZ(camera->down);
    const Ray ray = {XYZ(camera->position), normalize(direction)};
    return ray;
}
// #endregion camera_ray
