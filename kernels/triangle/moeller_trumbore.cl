// SPDX-License-Identifier: MIT
// Where a ray meets a triangle, with no threshold.
#include "triangle.cl"

static float intersect_triangle(const Ray ray, const Scene *scene, const int index, float2 *barycentric) {
    return intersect_ray_triangle(ray, triangle_edges(scene, index), barycentric);
}
