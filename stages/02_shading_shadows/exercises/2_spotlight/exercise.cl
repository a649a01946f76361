// SPDX-License-Identifier: MIT
// #stub
// Exercise 02.2: point lights with a shade.
// #solution
// Exercise 02.2, solved: the light fades between two cosines of the angle off its axis.
// #end

// kernels/light.cl
// #region point_light
#define SPOT_TARGET (float3)(-0.2f, 0.4f, 0.4f)
#define SPOT_FULL 0.16f  // radians off the axis
#define SPOT_EDGE 0.34f

static Illumination point_light_at(const Light light, const float3 position) {
    const float3 to_light = light.as.point.position.xyz - position;
    const float distance = length(to_light);
    const float share = distance / light.as.point.range;
    const float window = share < 1.0f ? 1.0f - share * share * share * share : 0.0f;
// #stub
    const float shade = 1.0f;  // your turn
// #solution
    const float3 axis = normalize(SPOT_TARGET - light.as.point.position.xyz);
    const float cosine = -dot(axis, to_light) / distance;
    const float shade = smoothstep(cos(SPOT_EDGE), cos(SPOT_FULL), cosine);
// #end
    const Illumination illumination = {
        to_light / distance,
        light.color.xyz * (shade * window * window / (distance * distance))};
    return illumination;
}
// #endregion point_light
