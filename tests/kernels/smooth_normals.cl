// SPDX-License-Identifier: MIT
// The normals of smooth facets as they are stored, three for each work-item.
#include "reflection.cl"
#include "triangle.cl"

// In 0 to 2 the normal where the second and third corner have these weights; in 4 to 6 how it
// mirrors.
__kernel void smooth_normals(__global float8 *results, __global const float4 *weights,
                             __global const float4 *directions, __global const Triangle *triangles,
                             __global const Single4 *corners, __global const Single4 *normals) {
    const size_t i = get_global_id(0);
    Scene scene;
    scene.triangles = triangles;
    scene.triangle_corners = corners;
    scene.vertex_normals = normals;
    Hit hit;
    hit.index = (int)i;
    hit.barycentric = weights[i].xy;
    Surface surface;
    fetch_triangle(&surface, &scene, hit);
    finish_triangle(&surface);
    results[i] = (float8)(surface.normal, 0.0f, reflect(directions[i].xyz, surface.normal), 0.0f);
}
