// SPDX-License-Identifier: MIT
// Exercise 09.3, solved: a brick is entered with the last of its slabs, and left with the first.

// kernels/bvh.cl
// #region leaf
#define TO_WIDE WIDE(convert_float)

// To where each ray enters the box, INFINITY where it does not; and the axis across which it does (Kay and
// Kajiya, Ray Tracing Complex Scenes, 1986).
static Wide enter_brick(const WideRays *rays, const float3 low, const float3 high, WideInt *axis) {
    const float lows[3] = {low.x, low.y, low.z};
    const float highs[3] = {high.x, high.y, high.z};
    Wide enter = -INFINITY;
    Wide leave = INFINITY;
    *axis = 0;
    for (int i = 0; i < 3; ++i) {
        const Wide origin = along_axis(&rays->origin, i);
        const Wide inverse = 1.0f / along_axis(&rays->direction, i);
        const Wide to_low = (lows[i] - origin) * inverse;
        const Wide to_high = (highs[i] - origin) * inverse;
        const Wide enters = smaller(to_low, to_high);
        const WideInt later = enters > enter;
        *axis = later ? (WideInt)(i) : *axis;
        enter = later ? enters : enter;
        leave = smaller(larger(to_low, to_high), leave);
    }
    return ((enter <= leave) & (enter > 0.0f)) ? enter : (Wide)(INFINITY);
}

static void try_leaf(const Scene *scene, WideRays *rays, const TriangleRays *shared,
                     const uint first, const uint count, WideHits *closest) {
    float3 low = INFINITY;
    float3 high = -INFINITY;
    for (uint i = first; i < first + count; ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const float3 point = XYZ(vload3(0, scene->facets[i].corners[corner]));
            low = min(low, point);
            high = max(high, point);
        }
    }
    WideInt axis;
    const Wide distance = enter_brick(rays, low, high, &axis);
    if (closest) {
        const WideInt closer = keep_closer(rays, closest, distance, SHAPE_TRIANGLE, (int)first);
        closest->barycentric_b = closer ? TO_WIDE(axis) : closest->barycentric_b;
    }
}
// #endregion leaf

// kernels/wide_render.cl
// #region trace_block
    WideHits hits[PACKETS];
    closest_hits(&scene, rays, hits);
    for (int packet = 0; packet < PACKETS; ++packet) {
        // A brick's hue is by its place among the leaves, so that one subtree's are alike; spheres and planes are grey.
        const Wide place = TO_WIDE(hits[packet].index) / scene.triangle_count;
        const WideInt is_brick = hits[packet].shape == SHAPE_TRIANGLE;
        const WideInt is_nothing = hits[packet].shape == SHAPE_NONE;
        const Wide side = 1.0f - 0.25f * hits[packet].barycentric_b;
        const Wide hue = 6.0f * place;
        const Wide red = fabs(hue - 3.0f) - 1.0f;
        const Wide green = 2.0f - fabs(hue - 2.0f);
        const Wide blue = 2.0f - fabs(hue - 4.0f);
        const Wide grey = is_nothing ? (Wide)(0.0f) : (Wide)(0.3f);
        colors[packet].x = is_brick ? side * clamp(red, 0.0f, 1.0f) : grey;
        colors[packet].y = is_brick ? side * clamp(green, 0.0f, 1.0f) : grey;
        colors[packet].z = is_brick ? side * clamp(blue, 0.0f, 1.0f) : grey;
    }
// #endregion trace_block
