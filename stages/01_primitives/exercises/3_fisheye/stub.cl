// SPDX-License-Identifier: MIT
// Exercise 01.3: a camera with a fisheye lens.

// kernels/camera.cl
// #region camera_ray
#define FISHEYE_EDGE (0.5f * M_PI_F)

static Ray camera_ray(const Camera *camera, const int2 pixel) {
    const float2 point = convert_float2(pixel) + camera->sample;
    // your turn
    const float3 direction =
        camera->corner.xyz + point.x * camera->right.xyz + point.y * camera->down.xyz;
    const Ray ray = {camera->position.xyz, normalize(direction)};
    return ray;
}
// #endregion camera_ray
