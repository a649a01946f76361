// SPDX-License-Identifier: MIT
// Core exercise 02 falloff: what arrives from a point light.

// kernels/light.cl
// #region point_light
static Illumination point_light_at(const Light light, const float3 position) {
    const float3 to_light = XYZ(light.as.point.position) - position;
    const Illumination illumination = {normalize(to_light), XYZ(light.color)};  // your turn
    return illumination;
}
// #endregion point_light
