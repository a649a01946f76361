// SPDX-License-Identifier: MIT
// Introduced by stage 10: where rays meet a triangle.
#include "packets/triangle.cl"

// #region wide_ray_triangle_woop
// Woop, Benthin and Wald, Watertight Ray/Triangle Intersection (Journal of Computer Graphics Techniques,
// 2013). Space is sheared until the ray is the z axis; then the ray's side of an edge is the sign of a
// difference that the triangle on the other side works out from the same numbers. So no ray slips
// through between the two. A sign of 0 counts for both.

// A corner as each ray sees it: beside the ray in x and y, and in z how many of its lengths away.
static Wide3 seen_along(const TriangleRays *shared, __global const Single *corner) {
    const Wide z = corner[shared->along] - shared->origin.z;
    const Wide3 seen = {FUSED(z, shared->shear.x, corner[shared->across] - shared->origin.x),
                        FUSED(z, shared->shear.y, corner[shared->down] - shared->origin.y), z * shared->shear.z};
    return seen;
}

static Wide3 seen_by_each(const TriangleRays *shared, const WideRays *rays, __global const Single *corner) {
    const Wide3 to_corner = wide_difference(wide3(XYZ(vload3(0, corner))), rays->origin);
    const Wide3 seen = {wide_dot(shared->rows[0], to_corner), wide_dot(shared->rows[1], to_corner),
                        wide_dot(shared->rows[2], to_corner)};
    return seen;
}

static void see_corners(const TriangleRays *shared, const WideRays *rays, __global const Single4 *positions,
                        Wide3 *seen) {
    if (shared->along == ALL_AXES) {
        for (int i = 0; i < 3; ++i) {
            seen[i] = seen_by_each(shared, rays, (__global const Single *)&positions[i]);
        }
        return;
    }
    for (int i = 0; i < 3; ++i) {
        seen[i] = seen_along(shared, (__global const Single *)&positions[i]);
    }
}

// To where each ray meets the triangle at a place of the leaves, and the weights there of its second and
// third corner; INFINITY for a miss. Every comparison is false for a NaN.
static Wide wide_ray_triangle(const WideRays *rays, const TriangleRays *shared, const Scene *scene,
                              const uint index, Wide *b, Wide *c) {
    Wide3 corners[3];
    see_corners(shared, rays, &scene->triangle_corners[3 * index], corners);
    // Not fused: the result would depend on the edge's direction.
    const Wide weight_a = corners[2].x * corners[1].y - corners[2].y * corners[1].x;
    const Wide weight_b = corners[0].x * corners[2].y - corners[0].y * corners[2].x;
    const Wide weight_c = corners[1].x * corners[0].y - corners[1].y * corners[0].x;
    const WideInt inside =
        (MIN(MIN(weight_a, weight_b), weight_c) >= 0.0f) | (MAX(MAX(weight_a, weight_b), weight_c) <= 0.0f);
    const Wide inverse = 1.0f / (weight_a + weight_b + weight_c);
    *b = weight_b * inverse;
    *c = weight_c * inverse;
    const Wide t = (weight_a * corners[0].z + weight_b * corners[1].z + weight_c * corners[2].z) * inverse;
    return (inside & (t > 0.0f)) ? t : (Wide)(INFINITY);
}
// #endregion wide_ray_triangle_woop
