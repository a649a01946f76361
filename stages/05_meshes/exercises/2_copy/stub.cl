// SPDX-License-Identifier: MIT
// Exercise 05.2: the scene's meshes once more, turned and moved.

// kernels/triangle.cl
// #region edges
// A triangle by its first corner and the ways from there to the other two.
typedef struct Edges {
    float3 corner;
    float3 b, c;
} Edges;

// The copy: turned about the y axis, then moved.
#define COPY_COSINE 0.6f
#define COPY_SINE 0.8f
#define COPY_POSITION (float3)(-1.9f, 0.0f, -1.5f)

static float3 turned(const float3 v, const float sine) {
    return (float3)(COPY_COSINE * v.x + sine * v.z, v.y, COPY_COSINE * v.z - sine * v.x);
}

static float3 to_copy(const float3 point) {
    return turned(point, COPY_SINE) + COPY_POSITION;
}

// The ray that meets the original where this one meets the copy.
static Ray to_original(const Ray ray) {
    return ray;  // your turn
}
// #endregion edges

// kernels/each_shape.cl
// #region closest_triangle
    for (int i = 0; i < scene->triangle_count; ++i) {  // your turn
        float2 barycentric;
        const float distance =
            intersect_ray_triangle(ray, triangle_edges(scene, i), &barycentric);
        if (keep_closer(closest, distance, SHAPE_TRIANGLE, i)) {
            closest->barycentric = barycentric;
        }
    }
// #endregion closest_triangle

// #region ray_any_triangle
    for (int i = 0; i < scene->triangle_count; ++i) {  // your turn
        float2 barycentric;
        if (intersect_ray_triangle(ray, triangle_edges(scene, i), &barycentric) < INFINITY) {
            return true;
        }
    }
// #endregion ray_any_triangle

// #region line_any_triangle
    for (int i = 0; i < scene->triangle_count; ++i) {  // your turn
        if (intersect_line_triangle(line, triangle_edges(scene, i))) {
            return true;
        }
    }
// #endregion line_any_triangle

// kernels/trace.cl
// #region hit_surface
            const Surface surface = surface_at(scene, incoming.ray, hit);  // your turn
// #endregion hit_surface
