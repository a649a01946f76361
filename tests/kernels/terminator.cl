// SPDX-License-Identifier: MIT
// Facets of smooth meshes, one for each work-item: how far above them the mesh is, and how much
// light they get.
#include "surface.cl"
#include "terminator/hanika.cl"

// Where the second and third corner have these weights.
__kernel void lifts(__global float4 *results, __global const float4 *weights,
                    __global const float4 *directions, __global const Triangle *triangles,
                    __global const Single4 *corners, __global const Single4 *normals) {
    const size_t i = get_global_id(0);
    Scene scene;
    scene.triangles = triangles;
    scene.triangle_corners = corners;
    scene.vertex_normals = normals;
    Hit hit;
    hit.distance = 1.0f;
    hit.shape = SHAPE_TRIANGLE;
    hit.index = (int)i;
    hit.barycentric = weights[i].xy;
    const Ray ray = {(float3)(0.0f), directions[i].xyz};
    const Surface surface = surface_at(&scene, ray, hit);
    results[i] = (float4)(lift_off_facet(&scene, &surface, hit), 0.0f);
}

__kernel void shadowings(__global float *results, __global const float4 *facets,
                         __global const float4 *normals, __global const float4 *directions) {
    const size_t i = get_global_id(0);
    Surface surface;
    surface.geometric_normal = facets[i].xyz;
    surface.normal = normals[i].xyz;
    results[i] = shadowing(&surface, directions[i].xyz, dot(surface.normal, directions[i].xyz));
}
