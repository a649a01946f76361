// SPDX-License-Identifier: MIT
// #stub
// Exercise 05.4: a test for triangles between which no ray slips through.
// #solution
// Exercise 05.4, solved: the ray's side of each edge is the sign of a volume, of which the triangle beyond that edge works
// out the same bits.
// #end

// kernels/triangle.cl
// #region triangle_edges
typedef struct Edges {
    float3 corner;
    float3 b, c;
// #stub
// #solution
    float3 second, third;  // corners: corner + b would be rounded
// #end
} Edges;

static float3 triangle_corner(const Scene *scene, const int index, const int corner) {
    return XYZ(scene->triangle_corners[3 * index + corner]);
}

static Edges triangle_edges(const Scene *scene, const int index) {
// #stub
    const float3 corner = triangle_corner(scene, index, 0);
    const Edges edges = {corner, triangle_corner(scene, index, 1) - corner,
                         triangle_corner(scene, index, 2) - corner};
    return edges;  // your turn
// #solution
    const float3 first = triangle_corner(scene, index, 0);
    const float3 second = triangle_corner(scene, index, 1);
    const float3 third = triangle_corner(scene, index, 2);
    const Edges edges = {first, second - first, third - first, second, third};
    return edges;
// #end
}
// #endregion triangle_edges

// #region ray_triangle
// #stub
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
// #solution
// Without built-in functions: cross() may fuse one of its two products, and then is no longer its own
// opposite when its arguments change places.
static float volume(const float3 along, const float3 p, const float3 q) {
    const float3 area = p.yzx * q.zxy - p.zxy * q.yzx;
    return along.x * area.x + along.y * area.y + along.z * area.z;
}

// Six times the volumes of the tetrahedra of `along` and each edge, seen from the origin (Kensler and
// Shirley, Optimizing Ray-Triangle Intersection via Automated Search, 2006). A sign of 0 counts for both.
static float intersect_volumes(const float3 origin, const float3 along, const Edges triangle,
                               float2 *barycentric) {
    const float3 first = triangle.corner - origin;
    const float3 second = triangle.second - origin;
    const float3 third = triangle.third - origin;
    const float a = volume(along, second, third);
    const float b = volume(along, third, first);
    const float c = volume(along, first, second);
    const float sum = a + b + c;
    const bool one_sign = (a >= 0.0f && b >= 0.0f && c >= 0.0f) || (a <= 0.0f && b <= 0.0f && c <= 0.0f);
    if (!one_sign || sum == 0.0f) {
        return INFINITY;
    }
    *barycentric = (float2)(b, c) / sum;
    const float3 hit = (a * first + b * second + c * third) / sum;
    const float t = dot(hit, along) / dot(along, along);
    return t > 0.0f ? t : INFINITY;
}
// #end

static float intersect_ray_triangle(const Ray ray, const Edges triangle, float2 *barycentric) {
// #stub
    return moeller_trumbore(ray.origin, ray.direction, triangle, barycentric);  // your turn
// #solution
    return intersect_volumes(ray.origin, ray.direction, triangle, barycentric);
// #end
}
// #endregion ray_triangle

// #region line_triangle
static bool intersect_line_triangle(const Line line, const Edges triangle) {
    float2 barycentric;
// #stub
    return moeller_trumbore(line.origin, line.destination - line.origin, triangle, &barycentric)
           < 1.0f;  // your turn
// #solution
    return intersect_volumes(line.origin, line.destination - line.origin, triangle, &barycentric)
           < 1.0f;
// #end
}
// #endregion line_triangle
