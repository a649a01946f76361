// SPDX-License-Identifier: MIT
// Introduced by stage 10: where rays meet a sphere.
#include "packets/wide.cl"

// #region wide_ray_sphere_haines
// Of the two roots the one without a difference is worked out, and the other from their product c (Haines
// et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019, chapter 7). And the
// perpendicular is rounded once, not on its way, where the device can do that; what `nearest` is off by is
// taken from it afterwards.
static Wide wide_ray_sphere(const WideRays *rays, const float3 center, const float radius) {
    const Wide3 to_center = wide_difference(wide3(center), rays->origin);
    const Wide nearest = wide_dot(to_center, rays->direction);
    const Wide3 nearly = wide_fused(-nearest, rays->direction, to_center);
    const Wide3 perpendicular = wide_fused(-wide_dot(nearly, rays->direction), rays->direction, nearly);
    const Wide half_chord = sqrt(radius * radius - wide_dot(perpendicular, perpendicular));
    const Wide c = wide_dot(to_center, to_center) - radius * radius;
    const Wide sum = nearest + (nearest < 0.0f ? -half_chord : half_chord);
    const WideInt is_sum = (c < 0.0f) ^ (nearest < 0.0f);
    const Wide distance = is_sum ? sum : c / sum;
    return distance > 0.0f ? distance : (Wide)(INFINITY);
}
// #endregion wide_ray_sphere_haines
