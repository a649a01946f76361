// SPDX-License-Identifier: MIT
// Exercise 05.4: a test for triangles between which no ray slips through.

// kernels/triangle.cl
// #region triangle_edges
typedef struct Edges {
    float3 corner;
    float3 b, c;
} Edges;

static float3 triangle_corner(const Scene *scene, const int index, const int corner) {
    return XYZ(scene->triangle_corners[3 * index + corner]);
}

static Edges triangle_edges(const Scene *scene, const int index) {
    const float3 corner = triangle_corner(scene, index, 0);
    const Edges edges = {corner, triangle_corner(scene, index, 1) - corner,
                         triangle_corner(scene, index, 2) - corner};
    return edges;  // your turn
}
// #endregion triangle_edges

// #region ray_triangle
static float moeller_trumbore(const float3 origin, const float3 along, const Edges triangle,
                             float2 *barycentric) {
    const float3 p = cross(along, triangle.c);
    const float determinant = dot(triangle.b, p);
    if (determinant == 0.0f) {
        return INFINITY;
    }
    const float inverse = 1.0f / determinant;
    const float3 to_origin = origin - triangle.corner;
    const float b = dot(to_origin, p) * inverse;
    const float3 q = cross(to_origin, triangle.b);
    const float c = dot(along, q) * inverse;
    if (!(b >= 0.0f && c >= 0.0f && b + c <= 1.0f)) {
        return INFINITY;
    }
    const float t = dot(triangle.c, q) * inverse;
    *barycentric = (float2)(b, c);
    return t > 0.0f ? t : INFINITY;
}

static float intersect_ray_triangle(const Ray ray, const Edges triangle, float2 *barycentric) {
    return moeller_trumbore(ray.origin, ray.direction, triangle, barycentric);  // your turn
}
// #endregion ray_triangle

// #region line_triangle
static bool intersect_line_triangle(const Line line, const Edges triangle) {
    float2 barycentric;
    return moeller_trumbore(line.origin, line.destination - line.origin, triangle, &barycentric)
           < 1.0f;  // your turn
}
// #endregion line_triangle
