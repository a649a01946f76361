// SPDX-License-Identifier: MIT
// Where a ray meets a triangle, with a threshold as in the code of Möller and Trumbore's paper (theirs is 1e-6)
// and in much since. But the determinant shrinks with the square of a triangle's size, and small meshes vanish.
#include "triangle.cl"

static float intersect_triangle(const Ray ray, const Scene *scene, const int index, float2 *barycentric) {
    const Edges edges = triangle_edges(scene, index);
    const float determinant = dot(edges.b, cross(ray.direction, edges.c));
    return fabs(determinant) > 1e-5f ? intersect_ray_triangle(ray, edges, barycentric) : INFINITY;
}
