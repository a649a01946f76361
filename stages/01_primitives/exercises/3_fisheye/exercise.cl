// SPDX-License-Identifier: MIT
// #stub
// Exercise 01.3: a camera with a fisheye lens.
// #solution
// Exercise 01.3, solved: the angle off the view's middle is in proportion to the distance from the picture's.
// #end

// kernels/camera.cl
// #region camera_ray
#define FISHEYE_EDGE (0.5f * M_PI_F)

static Ray camera_ray(const Camera *camera, const int2 pixel) {
    const float2 point = convert_float2(pixel) + camera->sample;
// #stub
    // your turn
    const float3 direction =
        camera->corner.xyz + point.x * camera->right.xyz + point.y * camera->down.xyz;
    const Ray ray = {camera->position.xyz, normalize(direction)};
// #solution
    const float2 middle = 0.5f * convert_float2(camera->size);
    const float3 forward =
        normalize(camera->corner.xyz + middle.x * camera->right.xyz + middle.y * camera->down.xyz);
    const float2 aside = (point - middle) / middle.x;
    const float3 lean =
        aside.x * normalize(camera->right.xyz) + aside.y * normalize(camera->down.xyz);
    const float away = length(aside);
    const float angle = FISHEYE_EDGE * away;
    const float share = away > 0.0f ? sin(angle) / away : 0.0f;  // lean is as long as `away`
    const Ray ray = {camera->position.xyz, normalize(cos(angle) * forward + share * lean)};
// #end
    return ray;
}
// #endregion camera_ray
