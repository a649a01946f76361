// SPDX-License-Identifier: MIT
// Introduced by stage 10: where WIDTH rays meet a triangle.
#include "scene.cl"
#include "triangle.cl"
#include "packets/wide.cl"

// #region triangle_rays
// What is the same for all triangles that a packet of rays meets: the rays, sheared.
typedef struct TriangleRays {
    int across, down, along;  // which axis becomes x, y and z, or ALL_AXES for each ray its own
    Wide3 origin, shear;      // in that order; what is added, for each length of z, to x, y and z
    Wide3 rows[3];            // of the matrix that does the same, where each ray has its own axis
} TriangleRays;
// #endregion triangle_rays

// #region wide_moeller_trumbore
// As moeller_trumbore (triangle.cl), of a determinant that is larger than `threshold`.
static Wide wide_moeller_trumbore(const WideRays *rays, const Scene *scene, const uint index, Wide *b, Wide *c,
                                  const float threshold) {
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
    const WideInt hits =
        (*b >= 0.0f) & (*c >= 0.0f) & (*b + *c <= 1.0f) & (t > 0.0f) & (fabs(determinant) > threshold);
    return hits ? t : (Wide)(INFINITY);
}
// #endregion wide_moeller_trumbore

// #region shear
// The axis that becomes z is one that no ray runs nearly across; of rays with no such axis in common, each
// has the one that it is longest along.
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
    const Wide3 rows[3] = {{by_x   ? shear.y
                            : by_y ? zero
                                   : one,
                            by_x   ? one
                            : by_y ? shear.z
                                   : zero,
                            by_x   ? zero
                            : by_y ? one
                                   : shear.x},
                           {by_x   ? shear.z
                            : by_y ? one
                                   : zero,
                            by_x   ? zero
                            : by_y ? shear.x
                                   : one,
                            by_x   ? one
                            : by_y ? zero
                                   : shear.y},
                           {by_x ? inverse : zero, by_y ? inverse : zero, (by_x | by_y) ? zero : inverse}};
    for (int i = 0; i < 3; ++i) {
        shared->rows[i] = rows[i];
    }
}

static TriangleRays triangle_rays(const WideRays *rays, const int axis) {
    TriangleRays shared;
    shared.along = axis;
    if (axis == ALL_AXES) {
        shear_each(&shared, rays->direction);
        return shared;
    }
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
// #endregion shear
