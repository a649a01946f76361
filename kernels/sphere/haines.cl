// SPDX-License-Identifier: MIT
// Where rays meet a sphere.
#include "ray.cl"

// #region ray_sphere
// Of the two roots the one without a difference is worked out, and the other from their product c (Haines
// et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019, chapter 7). And the
// perpendicular is rounded once, not on its way, where the device can do that; what `nearest` is off by is
// taken from it afterwards. Every comparison is false where half the chord is not a number.
static float intersect_ray_sphere(const Ray ray, const float3 center, const float radius) {
    const float3 to_center = center - ray.origin;
    const float nearest = dot(to_center, ray.direction);
    const float3 nearly = FUSED((float3)(-nearest), ray.direction, to_center);
    const float3 perpendicular = FUSED((float3)(-dot(nearly, ray.direction)), ray.direction, nearly);
    const float half_chord = sqrt(radius * radius - dot(perpendicular, perpendicular));
    const float c = dot(to_center, to_center) - radius * radius;
    const float sum = nearest + (nearest < 0.0f ? -half_chord : half_chord);
    const float distance = (c < 0.0f) != (nearest < 0.0f) ? sum : c / sum;
    return distance > 0.0f ? distance : INFINITY;
}
// #endregion ray_sphere
