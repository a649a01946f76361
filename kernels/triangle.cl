// SPDX-License-Identifier: MIT
// Introduced by stage 05: where rays and lines meet a triangle, and what is there.
#include "scene.cl"

// #region triangle_positions
typedef struct Corners {
    float3 a, b, c;
} Corners;

static Corners triangle_positions(const Scene *scene, const int index) {
    const Triangle triangle = scene->triangles[index];
    const Corners corners = {scene->vertex_positions[triangle.vertices[0]].xyz,
                             scene->vertex_positions[triangle.vertices[1]].xyz,
                             scene->vertex_positions[triangle.vertices[2]].xyz};
    return corners;
}
// #endregion triangle_positions

// #region ray_triangle
// Fast, Minimum Storage Ray/Triangle Intersection (Möller and Trumbore, 1997), from both
// sides. `determinant` shrinks with the square of the triangle's size, so it is compared with zero
// and nothing else: any other threshold would make small meshes vanish. Every comparison is false
// for a NaN.
static float moller_trumbore(const float3 origin, const float3 along, const Corners triangle,
                             float2 *barycentric) {
    const float3 edge_b = triangle.b - triangle.a;
    const float3 edge_c = triangle.c - triangle.a;
    const float3 p = cross(along, edge_c);
    const float determinant = dot(edge_b, p);
    if (determinant == 0.0f) {
        return INFINITY;
    }
    const float inverse = 1.0f / determinant;
    const float3 to_origin = origin - triangle.a;
    const float b = dot(to_origin, p) * inverse;
    if (!(b >= 0.0f && b <= 1.0f)) {
        return INFINITY;
    }
    const float3 q = cross(to_origin, edge_b);
    const float c = dot(along, q) * inverse;
    if (!(c >= 0.0f && b + c <= 1.0f)) {
        return INFINITY;
    }
    const float t = dot(edge_c, q) * inverse;
    *barycentric = (float2)(b, c);
    return t > 0.0f ? t : INFINITY;
}

static float intersect_ray_triangle(const Ray ray, const Corners triangle, float2 *barycentric) {
    return moller_trumbore(ray.origin, ray.direction, triangle, barycentric);
}
// #endregion ray_triangle

// #region line_triangle
// Measured in lengths of the line, its destination is at 1.
static bool intersect_line_triangle(const Line line, const Corners triangle) {
    float2 barycentric;
    return moller_trumbore(line.origin, line.destination - line.origin, triangle, &barycentric)
           < 1.0f;
}
// #endregion line_triangle

// #region triangle_surface
// The corners' normals are blended by the barycentric coordinates that the intersection found
// (paper, section 6); so is the position, which keeps it in the plane of the triangle.
static void triangle_surface(Surface *surface, const Scene *scene, const Hit hit) {
    const Triangle triangle = scene->triangles[hit.index];
    const Corners corners = triangle_positions(scene, hit.index);
    const float b = hit.barycentric.x;
    const float c = hit.barycentric.y;
    const float a = 1.0f - b - c;
    surface->position = a * corners.a + b * corners.b + c * corners.c;
    surface->normal = normalize(a * scene->vertex_normals[triangle.vertices[0]].xyz
                                + b * scene->vertex_normals[triangle.vertices[1]].xyz
                                + c * scene->vertex_normals[triangle.vertices[2]].xyz);
    const float3 facet = normalize(cross(corners.b - corners.a, corners.c - corners.a));
    surface->geometric_normal = dot(facet, surface->normal) < 0.0f ? -facet : facet;
    surface->material = triangle.material;
#if HAS_MESH_TEXTURES
    surface->texture_coordinates = a * scene->vertex_texture_coordinates[triangle.vertices[0]]
                                   + b * scene->vertex_texture_coordinates[triangle.vertices[1]]
                                   + c * scene->vertex_texture_coordinates[triangle.vertices[2]];
#elif HAS_TEXTURES
    surface->texture_coordinates = (float2)(0.0f);
#endif
}
// #endregion triangle_surface
