// SPDX-License-Identifier: MIT
// Introduced by stage 09: a tree of boxes, so that a ray tries few of the spheres and triangles. It stands in for
// each_shape.cl.
#include "box/robust.cl"
#include "cutout.cl"
#include "scene.cl"
#include "sphere.cl"
#include "triangle/woop.cl"

// #region enter_boxes
// Where the ray enters each box of a node; below 0 where it is not in it anywhere before t_max. A box is where
// three slabs meet (Kay and Kajiya, Ray Tracing Complex Scenes, 1986). Rounding moves a plane by some units in the
// last place of the two coordinates that it is measured between: the host has padded the boxes
// (common/device/bvh.cpp), here is the padding for where the ray is. With it, a ray in the plane of a side stays
// inside. fmax and fmin keep the box where a distance is not a number.
static float4 enter_boxes(__global const BvhNode *node, const Ray ray, const float t_max) {
    const float origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const float direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    float4 enter = 0.0f, leave = t_max;
#pragma unroll  // else PoCL leaves both arrays in memory
    for (int axis = 0; axis < 3; ++axis) {
        const float inverse =
            1.0f / (fabs(direction[axis]) < SMALLEST_DIRECTION ? SMALLEST_DIRECTION : direction[axis]);
        const float padding = copysign(origin[axis] * PADDING, inverse);
        const float4 near = XYZW(node->planes[inverse < 0.0f ? axis + 3 : axis]);
        const float4 far = XYZW(node->planes[inverse < 0.0f ? axis : axis + 3]);
        enter = fmax(enter, FUSED(near, (float4)(inverse), (float4)(-(origin[axis] + padding) * inverse)));
        leave = fmin(leave, FUSED(far, (float4)(inverse), (float4)(-(origin[axis] - padding) * inverse)));
    }
    return enter <= leave ? enter : (float4)(-1.0f);
}
// #endregion enter_boxes

// #region leaf
// The shapes of a leaf, each of them tried: `count` triangles, or -count spheres.
static void try_leaf(const Scene *scene, const Ray ray, const int first, const int count, Hit *closest) {
    if (HAS_SPHERES) {
        for (int i = first; i < first - count; ++i) {
            const Sphere sphere = scene->spheres[i];
            keep_closer(closest, intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius), SHAPE_SPHERE, i);
        }
    }
    if (HAS_TRIANGLES) {
        for (int i = first; i < first + count; ++i) {
            float2 barycentric;
            const float t = intersect_triangle(ray, scene, i, &barycentric);
            if (HAS_CUTOUTS && t < closest->distance && is_cut_out(scene, i, barycentric)) {
                continue;
            }
            closest->barycentric = keep_closer(closest, t, SHAPE_TRIANGLE, i) ? barycentric : closest->barycentric;
        }
    }
}
// #endregion leaf

// #region walk
// What the ray hits before `closest` takes its place; with `any` the first that is found will do. The nodes that
// are still to be looked into wait on a stack, the nearest last: what is hit there may spare the others.
static bool walk_tree(const Scene *scene, const Ray ray, const bool any, Hit *closest) {
    int nodes[BVH_STACK_SIZE];
    float enters[BVH_STACK_SIZE];
    nodes[0] = 0;
    enters[0] = 0.0f;
    int count = HAS_TREE;  // a scene of planes has none
    while (count > 0 && !(any && closest->shape != SHAPE_NONE)) {
        const int bottom = --count;
        if (enters[bottom] > closest->distance) {
            continue;  // something was hit before it
        }
        // #region look_into
        __global const BvhNode *node = &scene->bvh_nodes[nodes[bottom]];
        // #endregion look_into
        float t[4];
        vstore4(enter_boxes(node, ray, closest->distance), 0, t);
        // #region children
        for (int child = 0; child < 4; ++child) {
            if (t[child] >= 0.0f && node->count[child] != 0) {
                try_leaf(scene, ray, node->first[child], node->count[child], closest);
            } else if (t[child] >= 0.0f) {
                // #region push
                int place = count++;
                for (; place > bottom && enters[place - 1] < t[child]; --place) {
                    nodes[place] = nodes[place - 1];
                    enters[place] = enters[place - 1];
                }
                nodes[place] = node->first[child];
                enters[place] = t[child];
                // #endregion push
            }
        }
        // #endregion children
    }
    return closest->shape != SHAPE_NONE;
}
// #endregion walk

// #region tree_hit
static void closest_shape(const Scene *scene, const Ray ray, Hit *closest) {
    walk_tree(scene, ray, false, closest);
}

static bool any_shape_on_ray(const Scene *scene, const Ray ray) {
    Hit hit = {INFINITY, SHAPE_NONE};
    return walk_tree(scene, ray, true, &hit);
}

static bool any_shape_on_line(const Scene *scene, const Line line) {
    const Ray ray = {line.origin, normalize(line.destination - line.origin)};
    Hit hit = {distance(line.origin, line.destination), SHAPE_NONE};
    return walk_tree(scene, ray, true, &hit);
}
// #endregion tree_hit
