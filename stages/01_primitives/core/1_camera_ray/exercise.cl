// SPDX-License-Identifier: MIT
// Core exercise 01 camera_ray: the ray that a pixel sees along.

// kernels/camera.cl
// #region camera_ray
// Of unit length, in world space.
static Ray camera_ray(const Camera *camera, const int2 pixel) {
    const float2 point = JOIN(TO_REAL, 2)(pixel) + XY(camera->sample);  // pixels from the upper left corner
    const float3 direction = XYZ(camera->corner);                       // your turn
    const Ray ray = {XYZ(camera->position), normalize(direction)};
    return ray;
}
// #endregion camera_ray
