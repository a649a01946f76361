// SPDX-License-Identifier: MIT
// Introduced by stage 02: how much light arrives at a point, if it does.
#include "scene.cl"

// #region light_at
typedef struct Illumination {
    float3 direction;   // towards the light, unit length
    float3 irradiance;  // on a surface that faces the light
} Illumination;

// #region point_light
// Inverse square falloff, windowed to end at the range without a step (Karis, Real Shading in Unreal
// Engine 4, 2013).
static Illumination point_light_at(const Light light, const float3 position) {
    const float3 to_light = XYZ(light.as.point.position) - position;
    const float distance = length(to_light);
    const float share = distance / light.as.point.range;
    const float window = share < 1.0f ? 1.0f - share * share * share * share : 0.0f;
    const Illumination illumination = {to_light / distance,
                                       XYZ(light.color) * (window * window / (distance * distance))};
    return illumination;
}
// #endregion point_light

static Illumination directional_light_at(const Light light) {
    const Illumination illumination = {-XYZ(light.as.directional.direction), XYZ(light.color)};
    return illumination;
}

// Known beforehand where the scene has lights of one kind.
static bool is_point(const Light light) {
    return HAS_POINT_LIGHT && HAS_DIRECTIONAL_LIGHT ? light.type == LIGHT_POINT : HAS_POINT_LIGHT;
}

static Illumination light_at(const Light light, const float3 position) {
    return is_point(light) ? point_light_at(light, position) : directional_light_at(light);
}
// #endregion light_at
