// SPDX-License-Identifier: MIT
// Introduced by stage 09: a tree of boxes, so that a ray tries few of the triangles.
#include "triangle.cl"

// #region slab
// A box is where three slabs meet (Kay and Kajiya, Ray Tracing Complex Scenes, 1986). This is what a
// ray's tests against all boxes have in common (Williams et al., An Efficient and Robust Ray-Box
// Intersection Algorithm, 2005).
typedef struct SlabRay {
    float3 origin;
    float3 inverse;  // of the direction; infinite along what it does not move
    int3 backwards;  // all bits set where it goes towards lower coordinates
} SlabRay;

static SlabRay slab_ray(const Ray ray) {
    const SlabRay slabs = {ray.origin, 1.0f / ray.direction, signbit(ray.direction)};
    return slabs;
}

// The second where the first is not a number. Compare and select are an instruction each; fmin and fmax
// are more.
static float smaller(const float a, const float b) {
    return a < b ? a : b;
}

static float larger(const float a, const float b) {
    return a > b ? a : b;
}

// Where the ray enters the box, INFINITY if it does not do so before `limit`. In the plane of a slab
// that it does not cross, 0 * INFINITY is not a number, and bounds nothing. The far side is moved on
// by the rounding of the three operations that it took, or a ray along an edge could miss the boxes
// on both sides (Ize, Robust BVH Ray Traversal, 2013).
static float enter_box(__global const BvhChild *box, const SlabRay *ray, const float limit) {
    const float rounding = 1.0f + 6.0f * 5.9604645e-8f;
    const float3 low = vload3(0, box->low);
    const float3 high = vload3(0, box->high);
    const float3 near = (select(low, high, ray->backwards) - ray->origin) * ray->inverse;
    const float3 far = (select(high, low, ray->backwards) - ray->origin) * ray->inverse * rounding;
    const float enter = larger(near.x, larger(near.y, larger(near.z, 0.0f)));
    const float leave = smaller(far.x, smaller(far.y, smaller(far.z, limit)));
    return enter <= leave ? enter : INFINITY;
}
// #endregion slab

// #region closest_triangle
static void closest_in_leaf(const Scene *scene, const Ray ray, __global const BvhChild *leaf,
                            Hit *closest) {
    for (uint i = leaf->first; i < leaf->first + leaf->count; ++i) {
        float2 barycentric;
        const float distance =
            intersect_ray_triangle(ray, triangle_positions(scene, i), &barycentric);
        if (distance < closest->distance) {
            closest->distance = distance;
            closest->shape = SHAPE_TRIANGLE;
            closest->index = i;
            closest->barycentric = barycentric;
        }
    }
}

// The nearer of a node's children first: what it hits may spare the other.
static void closest_triangle(const Scene *scene, const Ray ray, Hit *closest) {
    const SlabRay slabs = slab_ray(ray);
    uint waiting[BVH_DEPTH];
    float waiting_at[BVH_DEPTH];  // where the ray enters it
    int count = 1;
    waiting[0] = 0;
    waiting_at[0] = 0.0f;
    while (count > 0) {
        --count;
        if (waiting_at[count] >= closest->distance) {
            continue;  // a hit was found before it
        }
        __global const BvhNode *node = &scene->bvh_nodes[waiting[count]];
        float enter[2];
        for (int side = 0; side < 2; ++side) {
            __global const BvhChild *child = &node->children[side];
            enter[side] = enter_box(child, &slabs, closest->distance);
            if (child->count > 0 && enter[side] < INFINITY) {
                closest_in_leaf(scene, ray, child, closest);
                enter[side] = INFINITY;
            }
        }
        const int nearer = enter[1] < enter[0];
        for (int i = 0; i < 2; ++i) {
            const int side = i == 0 ? 1 - nearer : nearer;
            if (enter[side] < INFINITY) {
                waiting[count] = node->children[side].first;
                waiting_at[count] = enter[side];
                ++count;
            }
        }
    }
}
// #endregion closest_triangle

// #region any_triangle
static bool any_in_leaf(const Scene *scene, const Ray ray, const float limit,
                        __global const BvhChild *leaf) {
    for (uint i = leaf->first; i < leaf->first + leaf->count; ++i) {
        float2 barycentric;
        if (intersect_ray_triangle(ray, triangle_positions(scene, i), &barycentric) < limit) {
            return true;
        }
    }
    return false;
}

// Whether any triangle is in the way, up to `limit` lengths of the direction, which need not be a unit
// vector: a line is a ray whose direction ends at its destination.
static bool any_triangle(const Scene *scene, const Ray ray, const float limit) {
    const SlabRay slabs = slab_ray(ray);
    uint waiting[BVH_DEPTH];
    int count = 1;
    waiting[0] = 0;
    while (count > 0) {
        __global const BvhNode *node = &scene->bvh_nodes[waiting[--count]];
        for (int side = 0; side < 2; ++side) {
            __global const BvhChild *child = &node->children[side];
            if (enter_box(child, &slabs, limit) == INFINITY) {
                continue;
            }
            if (child->count == 0) {
                waiting[count++] = child->first;
            } else if (any_in_leaf(scene, ray, limit, child)) {
                return true;
            }
        }
    }
    return false;
}
// #endregion any_triangle
