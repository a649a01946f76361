// SPDX-License-Identifier: MIT
// A ray against the boxes of a node, one of each a work-item.
#include "tree.cl"

// Of the first child: in x whether the ray enters it, in y where; in z the bits of the children
// that it enters.
__kernel void enter(__global float4 *results, __global const float4 *origins,
                    __global const float4 *directions, __global const BvhNode *nodes,
                    __global const float *t_max_each) {
    const size_t i = get_global_id(0);
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    const float4 t = enter_boxes(&nodes[i], ray, t_max_each[i]);
    const int4 enters = (t >= 0.0f) & (int4)(1, 2, 4, 8);
    results[i] = (float4)(enters.x, t.x, enters.x | enters.y | enters.z | enters.w, enters.x);
}

__kernel void enter_all_ways(__global int *enters, __global const float4 *origins,
                             __global const float4 *directions, __global const BvhNode *nodes) {
    const size_t i = get_global_id(0);
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    enters[i] = enter_boxes(&nodes[i], ray, INFINITY).x >= 0.0f;
}

// In x whether the ray is said to hit the triangle in the first child's box; a ray has none beside
// it.
__kernel void enter_beside(__global int4 *results, __global const float4 *origins,
                           __global const float4 *directions, __global const float4 *others,
                           __global const int *counts, __global const BvhNode *nodes,
                           __global const Single4 *corners) {
    const size_t i = get_global_id(0);
    Scene scene;
    scene.triangle_corners = &corners[3 * i];
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    float2 barycentric;
    const bool hits = intersect_triangle(ray, &scene, 0, &barycentric) < INFINITY;
    results[i] = (int4)(hits && enter_boxes(&nodes[i], ray, INFINITY).x >= 0.0f, 0, 0, 0);
}
