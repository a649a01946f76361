// SPDX-License-Identifier: MIT
// Introduced by stage 11: where light ends on a mesh whose normals make it look smooth. Light is asked for on the
// smooth surface that a facet stands for, so that the facet itself casts no shadow there.
#include "triangle.cl"

// #region lift_off_facet
// From a hit point to that surface: up to the tangent plane of each corner, where the point is beneath it, blended
// by the barycentric coordinates (Hanika, Hacking the Shadow Terminator, Ray Tracing Gems II, 2021, section 4.3).
// In a hollow the point is above them, and stays. So it does where normals lean so far that it would go beneath
// its facet.
static float3 lift_off_facet(const Scene *scene, const Surface *surface, const Hit hit) {
    const Triangle triangle = scene->triangles[hit.index];
    const float b = hit.barycentric.x, c = hit.barycentric.y;
    const float weights[3] = {1.0f - b - c, b, c};
    const float side = surface->from_behind ? -1.0f : 1.0f;
    float3 lift = (float3)(0.0f);
    for (int i = 0; i < 3; ++i) {
        const float3 normal = side * XYZ(scene->vertex_normals[triangle.vertices[i]]);
        const float height = dot(surface->position - triangle_corner(scene, hit.index, i), normal);
        lift -= weights[i] * MIN(height, 0.0f) * normal;
    }
    return dot(lift, surface->geometric_normal) > 0.0f ? lift : (float3)(0.0f);
}
// #endregion lift_off_facet

// The light is Lambert's.
static float shadowing(const Surface *surface, const float3 direction, const float cosine) {
    return 1.0f;
}
