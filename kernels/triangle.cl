// SPDX-License-Identifier: MIT
// Introduced by stage 05; extended by 06 (textures, colours of vertices): where rays and lines meet a
// triangle, and what is there.
#include "origin.cl"
#include "scene.cl"

// #region triangle_edges
// #region edges
// A triangle by its first corner and the ways from there to the other two.
typedef struct Edges {
    float3 corner, b, c;
} Edges;
// #endregion edges

static float3 triangle_corner(const Scene *scene, const int index, const int corner) {
    return XYZ(scene->triangle_corners[3 * index + corner]);
}

static Edges triangle_edges(const Scene *scene, const int index) {
    const float3 corner = triangle_corner(scene, index, 0);
    const Edges edges = {corner, triangle_corner(scene, index, 1) - corner,
                         triangle_corner(scene, index, 2) - corner};
    return edges;
}
// #endregion triangle_edges

// #region ray_triangle
// Fast, Minimum Storage Ray/Triangle Intersection (Möller and Trumbore, 1997), from both
// sides. `determinant` shrinks with the square of the triangle's size, so it is compared with zero
// and nothing else: any other threshold would make small meshes vanish. Every comparison is false
// for a NaN.
// #region moeller_trumbore
static float moeller_trumbore(const float3 origin, const float3 along, const Edges triangle, float2 *barycentric) {
    const float3 p = cross(along, triangle.c);
    const float determinant = dot(triangle.b, p);
    if (determinant == 0.0f) {
        return INFINITY;
    }
    const float inverse = 1.0f / determinant;
    const float3 to_origin = origin - triangle.corner;
    const float b = dot(to_origin, p) * inverse;
    if (!(b >= 0.0f && b <= 1.0f)) {
        return INFINITY;
    }
    const float3 q = cross(to_origin, triangle.b);
    const float c = dot(along, q) * inverse;
    if (!(c >= 0.0f && b + c <= 1.0f)) {
        return INFINITY;
    }
    const float t = dot(triangle.c, q) * inverse;
    *barycentric = (float2)(b, c);
    return t > 0.0f ? t : INFINITY;
}
// #endregion moeller_trumbore

static float intersect_ray_triangle(const Ray ray, const Edges triangle, float2 *barycentric) {
    return moeller_trumbore(ray.origin, ray.direction, triangle, barycentric);
}
// #endregion ray_triangle

// #region line_triangle
// Measured in lengths of the line, its destination is at 1.
static bool intersect_line_triangle(const Line line, const Edges triangle) {
    float2 barycentric;
    return moeller_trumbore(line.origin, line.destination - line.origin, triangle, &barycentric) < 1.0f;
}
// #endregion line_triangle

// #region blended_coordinates
static float2 blended_coordinates(const Scene *scene, const Triangle triangle, const float2 barycentric) {
    const float b = barycentric.x, c = barycentric.y;
    const float a = 1.0f - b - c;
    return a * XY(scene->vertex_texture_coordinates[triangle.vertices[0]])
           + b * XY(scene->vertex_texture_coordinates[triangle.vertices[1]])
           + c * XY(scene->vertex_texture_coordinates[triangle.vertices[2]]);
}
// #endregion blended_coordinates

// #region vertex_color
static float3 vertex_color(const Scene *scene, const Hit hit) {
    const Triangle triangle = scene->triangles[hit.index];
    const float b = hit.barycentric.x, c = hit.barycentric.y;
    const float a = 1.0f - b - c;
    return a * XYZ(scene->vertex_colors[triangle.vertices[0]])
           + b * XYZ(scene->vertex_colors[triangle.vertices[1]])
           + c * XYZ(scene->vertex_colors[triangle.vertices[2]]);
}
// #endregion vertex_color

// #region triangle_surface
// The corners' normals are blended by the barycentric coordinates that the intersection found
// (paper, section 6); the position, which they give too, stays in the plane of the triangle. Both
// normals are left as long as they come.
static void fetch_triangle(Surface *surface, const Scene *scene, const Hit hit) {
    const Triangle triangle = scene->triangles[hit.index];
    const Edges edges = triangle_edges(scene, hit.index);
    const float b = hit.barycentric.x, c = hit.barycentric.y;
    const float a = 1.0f - b - c;
    surface->position = edges.corner + b * edges.b + c * edges.c;
    // #region blended_normal
    surface->normal = a * XYZ(scene->vertex_normals[triangle.vertices[0]])
                      + b * XYZ(scene->vertex_normals[triangle.vertices[1]])
                      + c * XYZ(scene->vertex_normals[triangle.vertices[2]]);
    // #endregion blended_normal
    surface->geometric_normal = cross(edges.b, edges.c);
    // The sum is rounded by its parts; the next test of this triangle, by its extent.
    const float3 extent = max(fabs(edges.b), fabs(edges.c));
    surface->ray_offset = error_along(surface->geometric_normal, surface->position,
                                      GAMMA(6.0f) * (fabs(edges.corner) + extent)
                                          + GAMMA(8.0f) * max(extent.x, max(extent.y, extent.z)));
    surface->material = triangle.material;
    // #region mesh_coordinates
    if (HAS_TEXTURES) {
        surface->texture_coordinates = (float2)(0.0f);
    }
    if (HAS_MESH_TEXTURES) {
        surface->texture_coordinates = blended_coordinates(scene, triangle, hit.barycentric);
    }
    // #endregion mesh_coordinates
}

// #region finish_triangle
// The facet's normal is on the side of the vertices' normals, whichever way round the corners are.
static void finish_triangle(Surface *surface) {
    surface->normal = normalize(surface->normal);
    const float3 facet = normalize(surface->geometric_normal);
    surface->geometric_normal = dot(facet, surface->normal) < 0.0f ? -facet : facet;
}
// #endregion finish_triangle
// #endregion triangle_surface
