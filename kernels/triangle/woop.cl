// SPDX-License-Identifier: MIT
// Introduced by stage 09: where a ray meets a triangle, watertight.
#include "triangle.cl"

// #region woop
// The vector's axes in turn, until `axis` is the last.
static float3 turned_to(const float3 v, const int axis) {
    return axis == 0 ? v.yzx : axis == 1 ? v.zxy : v;
}

// Woop, Benthin and Wald, Watertight Ray/Triangle Intersection (Journal of Computer Graphics Techniques,
// 2013). Space is sheared until the ray is the z axis; then the ray's side of an edge is the sign of a
// difference that the triangle on the other side works out from the same numbers. So no ray slips
// through between the two. A sign of 0 counts for both. Every comparison is false for a NaN.
static float intersect_triangle(const Ray ray, const Scene *scene, const int index, float2 *barycentric) {
    const float3 length = fabs(ray.direction);
    const int axis = length.x > length.y && length.x > length.z ? 0 : length.y > length.z ? 1 : 2;
    const float3 direction = turned_to(ray.direction, axis);
    const float3 shear = (float3)(-direction.xy, 1.0f) * (1.0f / direction.z);
    const float3 a = turned_to(triangle_corner(scene, index, 0) - ray.origin, axis);
    const float3 b = turned_to(triangle_corner(scene, index, 1) - ray.origin, axis);
    const float3 c = turned_to(triangle_corner(scene, index, 2) - ray.origin, axis);
    const float3 z = {a.z, b.z, c.z};
    const float3 x = FUSED(z, (float3)(shear.x), (float3)(a.x, b.x, c.x));
    const float3 y = FUSED(z, (float3)(shear.y), (float3)(a.y, b.y, c.y));
    const float3 areas = y.yzx * x.zxy - y.zxy * x.yzx;  // not fused: it would depend on the edge's direction
    const float3 weights = areas * (1.0f / (areas.x + areas.y + areas.z));
    *barycentric = weights.yz;
    const float t = dot(weights, z) * shear.z;
    return fmin(fmin(weights.x, weights.y), weights.z) >= 0.0f && t > 0.0f ? t : INFINITY;
}
// #endregion woop
