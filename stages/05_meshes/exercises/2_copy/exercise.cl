// SPDX-License-Identifier: MIT
// #stub
// Exercise 05.2: the scene's meshes once more, turned and moved.
// #solution
// Exercise 05.2, solved: rays go to where the mesh is, and what they find comes back.
// #end

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

// #stub
// The ray that meets the original where this one meets the copy.
static Ray to_original(const Ray ray) {
    return ray;  // your turn
}
// #solution
// The point of the original that comes to this one.
static float3 from_copy(const float3 point) {
    return turned(point - COPY_POSITION, -COPY_SINE);
}

// The ray that meets the original where this one meets the copy.
static Ray to_original(const Ray ray) {
    const Ray moved = {from_copy(ray.origin), turned(ray.direction, -COPY_SINE)};
    return moved;
}
// #end
// #endregion edges

// kernels/each_shape.cl
// #region closest_triangle
// #stub
    for (int i = 0; i < scene->triangle_count; ++i) {  // your turn
        float2 barycentric;
        const float distance =
            intersect_ray_triangle(ray, triangle_edges(scene, i), &barycentric);
        if (keep_closer(closest, distance, SHAPE_TRIANGLE, i)) {
            closest->barycentric = barycentric;
        }
    }
// #solution
    const Ray moved = to_original(ray);
    for (int i = 0; i < 2 * scene->triangle_count; ++i) {
        const bool is_copy = i >= scene->triangle_count;
        const Edges triangle = triangle_edges(scene, is_copy ? i - scene->triangle_count : i);
        float2 barycentric;
        const float distance =
            intersect_ray_triangle(is_copy ? moved : ray, triangle, &barycentric);
        if (keep_closer(closest, distance, SHAPE_TRIANGLE, i)) {
            closest->barycentric = barycentric;
        }
    }
// #end
// #endregion closest_triangle

// #region ray_any_triangle
// #stub
    for (int i = 0; i < scene->triangle_count; ++i) {  // your turn
        float2 barycentric;
        if (intersect_ray_triangle(ray, triangle_edges(scene, i), &barycentric) < INFINITY) {
            return true;
        }
    }
// #solution
    const Ray moved = to_original(ray);
    for (int i = 0; i < scene->triangle_count; ++i) {
        const Edges triangle = triangle_edges(scene, i);
        float2 barycentric;
        if (intersect_ray_triangle(ray, triangle, &barycentric) < INFINITY
            || intersect_ray_triangle(moved, triangle, &barycentric) < INFINITY) {
            return true;
        }
    }
// #end
// #endregion ray_any_triangle

// #region line_any_triangle
// #stub
    for (int i = 0; i < scene->triangle_count; ++i) {  // your turn
        if (intersect_line_triangle(line, triangle_edges(scene, i))) {
            return true;
        }
    }
// #solution
    const Line moved = {from_copy(line.origin), from_copy(line.destination)};
    for (int i = 0; i < scene->triangle_count; ++i) {
        const Edges triangle = triangle_edges(scene, i);
        if (intersect_line_triangle(line, triangle) || intersect_line_triangle(moved, triangle)) {
            return true;
        }
    }
// #end
// #endregion line_any_triangle

// kernels/trace.cl
// #region hit_surface
// #stub
            Surface surface = surface_at(scene, incoming.ray, hit);  // your turn
// #solution
            const bool is_copy = hit.shape == SHAPE_TRIANGLE && hit.index >= scene->triangle_count;
            Hit of_original = hit;
            of_original.index -= is_copy ? scene->triangle_count : 0;
            Surface surface = surface_at(
                scene, is_copy ? to_original(incoming.ray) : incoming.ray, of_original);
            if (is_copy) {
                // The way there, and back for the next ray, is rounded too.
                const float3 ways = fabs(surface.position) + fabs(COPY_POSITION);
                surface.ray_offset += GAMMA(16.0f) * (ways.x + ways.y + ways.z);
                surface.position = to_copy(surface.position);
                surface.normal = turned(surface.normal, COPY_SINE);
                surface.geometric_normal = turned(surface.geometric_normal, COPY_SINE);
            }
// #end
// #endregion hit_surface
