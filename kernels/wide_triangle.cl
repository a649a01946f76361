// SPDX-License-Identifier: MIT
// Introduced by stage 09: where WIDTH rays meet a triangle.
#include "scene.cl"
#include "triangle.cl"
#include "wide.cl"

// #region wide_ray_triangle
// To where each ray meets the triangle at a place of the leaves, and the weights there of its second and
// third corner; INFINITY for a miss. Every comparison is false for a NaN.
#ifndef METHOD_TRIANGLE
#define METHOD_TRIANGLE woop
#endif
#define wide_ray_triangle JOIN(wide_ray_triangle_, METHOD_TRIANGLE)

// What is the same for all triangles that a packet of rays meets: the rays, sheared.
typedef struct TriangleRays {
    int across, down, along;  // which axis becomes x, y and z, or ALL_AXES for each ray its own
    Wide3 origin, shear;      // in that order; what is added, for each length of z, to x, y and z
#if WIDTH > 1
    Wide3 rows[3];  // of the matrix that does the same, where each ray has its own axis
#endif
} TriangleRays;

// #endregion wide_ray_triangle

// #region wide_ray_triangle_moeller_trumbore
// As moller_trumbore (triangle.cl), of a determinant that is larger than `threshold`.
static Wide moeller_trumbore(const WideRays *rays, const Scene *scene, const uint index, Wide *b,
                             Wide *c, const float threshold) {
    const Edges edges = triangle_edges(scene, index);
    const Wide3 edge_b = wide3(edges.b);
    const Wide3 edge_c = wide3(edges.c);
    const Wide3 p = wide_cross(rays->direction, edge_c);
    const Wide determinant = wide_dot(edge_b, p);
    const Wide inverse = 1.0f / determinant;
    const Wide3 to_origin = wide_difference(rays->origin, wide3(edges.corner));
    const Wide3 q = wide_cross(to_origin, edge_b);
    *b = wide_dot(to_origin, p) * inverse;
    *c = wide_dot(rays->direction, q) * inverse;
    const Wide t = wide_dot(edge_c, q) * inverse;
    const WideInt hits = (*b >= 0.0f) & (*c >= 0.0f) & (*b + *c <= 1.0f) & (t > 0.0f)
                         & (fabs(determinant) > threshold);
    return hits ? t : (Wide)(INFINITY);
}

static Wide wide_ray_triangle_moeller_trumbore(const WideRays *rays, const TriangleRays *shared,
                                               const Scene *scene, const uint index, Wide *b,
                                               Wide *c) {
    return moeller_trumbore(rays, scene, index, b, c, 0.0f);
}

// As in their paper's code and many since: but the determinant shrinks with the square of a triangle's
// size, and small meshes vanish.
static Wide wide_ray_triangle_threshold(const WideRays *rays, const TriangleRays *shared,
                                        const Scene *scene, const uint index, Wide *b, Wide *c) {
    return moeller_trumbore(rays, scene, index, b, c, 1e-5f);
}
// #endregion wide_ray_triangle_moeller_trumbore

// #region wide_ray_triangle_woop
// Woop, Benthin and Wald, Watertight Ray/Triangle Intersection (Journal of Computer Graphics Techniques,
// 2013). Space is sheared until the ray is the z axis; then the ray's side of an edge is the sign of a
// difference that the triangle on the other side works out from the same numbers. So no ray slips
// through between the two. A sign of 0 counts for both.
//
// The axis that becomes z is one that no ray runs nearly across; of rays with no such axis in common, each
// has the one that it is longest along.
#if WIDTH > 1
static void shear_each(TriangleRays *shared, const Wide3 d) {
    const Wide x = fabs(d.x);
    const Wide y = fabs(d.y);
    const Wide z = fabs(d.z);
    const WideInt by_x = (x > y) & (x > z);
    const WideInt by_y = !by_x & (y > z);
    const Wide inverse = 1.0f / (by_x ? d.x : by_y ? d.y : d.z);
    const Wide3 shear = wide_scaled(-inverse, d);
    const Wide zero = 0.0f;
    const Wide one = 1.0f;
    const Wide3 rows[3] = {
        {by_x ? shear.y : by_y ? zero : one, by_x ? one : by_y ? shear.z : zero,
         by_x ? zero : by_y ? one : shear.x},
        {by_x ? shear.z : by_y ? one : zero, by_x ? zero : by_y ? shear.x : one,
         by_x ? one : by_y ? zero : shear.y},
        {by_x ? inverse : zero, by_y ? inverse : zero, (by_x | by_y) ? zero : inverse}};
    for (int i = 0; i < 3; ++i) {
        shared->rows[i] = rows[i];
    }
}
#endif

static TriangleRays triangle_rays(const WideRays *rays, const int axis) {
    TriangleRays shared;
    shared.along = axis;
#if WIDTH > 1
    if (axis == ALL_AXES) {
        shear_each(&shared, rays->direction);
        return shared;
    }
#endif
    shared.across = axis == 2 ? 0 : axis + 1;
    shared.down = axis == 0 ? 2 : axis - 1;
    shared.origin.x = along_axis(&rays->origin, shared.across);
    shared.origin.y = along_axis(&rays->origin, shared.down);
    shared.origin.z = along_axis(&rays->origin, axis);
    shared.shear.z = 1.0f / along_axis(&rays->direction, axis);
    shared.shear.x = -along_axis(&rays->direction, shared.across) * shared.shear.z;
    shared.shear.y = -along_axis(&rays->direction, shared.down) * shared.shear.z;
    return shared;
}

// A corner as each ray sees it: beside the ray in x and y, and in z how many of its lengths away.
static Wide3 seen_along(const TriangleRays *shared, __global const StoredNumber *corner) {
    const Wide z = LOAD_NUMBER(corner, shared->along) - shared->origin.z;
    const Wide3 seen = {
        FUSED(z, shared->shear.x, LOAD_NUMBER(corner, shared->across) - shared->origin.x),
        FUSED(z, shared->shear.y, LOAD_NUMBER(corner, shared->down) - shared->origin.y),
        z * shared->shear.z};
    return seen;
}

#if WIDTH > 1
static Wide3 seen_by_each(const TriangleRays *shared, const WideRays *rays,
                          __global const StoredNumber *corner) {
    const Wide3 to_corner = wide_difference(wide3(LOAD_COORDINATES(corner)), rays->origin);
    const Wide3 seen = {wide_dot(shared->rows[0], to_corner), wide_dot(shared->rows[1], to_corner),
                        wide_dot(shared->rows[2], to_corner)};
    return seen;
}
#endif

static void see_corners(const TriangleRays *shared, const WideRays *rays,
                        __global const StoredFacet *facet, Wide3 *seen) {
#if WIDTH > 1
    if (shared->along == ALL_AXES) {
        for (int i = 0; i < 3; ++i) {
            seen[i] = seen_by_each(shared, rays, facet->corners[i]);
        }
        return;
    }
#endif
    for (int i = 0; i < 3; ++i) {
        seen[i] = seen_along(shared, facet->corners[i]);
    }
}

static Wide wide_ray_triangle_woop(const WideRays *rays, const TriangleRays *shared,
                                   const Scene *scene, const uint index, Wide *b, Wide *c) {
    Wide3 corners[3];
    see_corners(shared, rays, &scene->facets[index], corners);
    // Not fused: the result would depend on the edge's direction.
    const Wide weight_a = corners[2].x * corners[1].y - corners[2].y * corners[1].x;
    const Wide weight_b = corners[0].x * corners[2].y - corners[0].y * corners[2].x;
    const Wide weight_c = corners[1].x * corners[0].y - corners[1].y * corners[0].x;
    const WideInt inside = (smaller(smaller(weight_a, weight_b), weight_c) >= 0.0f)
                           | (larger(larger(weight_a, weight_b), weight_c) <= 0.0f);
    const Wide inverse = 1.0f / (weight_a + weight_b + weight_c);
    *b = weight_b * inverse;
    *c = weight_c * inverse;
    const Wide t =
        (weight_a * corners[0].z + weight_b * corners[1].z + weight_c * corners[2].z) * inverse;
    return (inside & (t > 0.0f)) ? t : (Wide)(INFINITY);
}
// #endregion wide_ray_triangle_woop

// #region wide_ray_triangle_baldwin_weber
// Baldwin and Weber, Fast Ray-Triangle Intersections by Coordinate Transformation (Journal of Computer
// Graphics Techniques, 2016): each triangle brings the map that takes it to the unit triangle. What the
// map has 0 and 1 for, since the normal is longest along `axis`, is not stored.
#if HAS_FACET_MAPS
static Wide wide_ray_triangle_baldwin_weber(const WideRays *rays, const TriangleRays *shared,
                                            const Scene *scene, const uint index, Wide *b,
                                            Wide *c) {
    const FacetMap map = scene->facet_maps[index];
    const int u = map.axis == 2 ? 0 : map.axis + 1;
    const int v = map.axis == 0 ? 2 : map.axis - 1;
    const Wide from_u = along_axis(&rays->origin, u);
    const Wide from_v = along_axis(&rays->origin, v);
    const Wide to_u = along_axis(&rays->direction, u);
    const Wide to_v = along_axis(&rays->direction, v);
    const Wide above = along_axis(&rays->origin, map.axis) + map.along[0] * from_u
                       + map.along[1] * from_v + map.along[2];
    const Wide rising =
        along_axis(&rays->direction, map.axis) + map.along[0] * to_u + map.along[1] * to_v;
    const Wide t = -above / rising;
    const Wide at_u = from_u + t * to_u;
    const Wide at_v = from_v + t * to_v;
    *b = map.to_b[0] * at_u + map.to_b[1] * at_v + map.to_b[2];
    *c = map.to_c[0] * at_u + map.to_c[1] * at_v + map.to_c[2];
    const WideInt hits = (*b >= 0.0f) & (*c >= 0.0f) & (*b + *c <= 1.0f) & (t > 0.0f);
    return hits ? t : (Wide)(INFINITY);
}
#endif
// #endregion wide_ray_triangle_baldwin_weber
