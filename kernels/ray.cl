// SPDX-License-Identifier: MIT
// Introduced by stage 01: what is sent through the scene, and what comes back.
#include "scene_types.h"

// #region ray
// Starts at its origin and never ends.
typedef struct Ray {
    float3 origin;
    float3 direction;  // unit length
} Ray;

// Starts at its origin and ends at its destination: for shadows (paper, section 2).
typedef struct Line {
    float3 origin;
    float3 destination;
} Line;
// #endregion ray

typedef enum Shape { SHAPE_NONE, SHAPE_SPHERE, SHAPE_PLANE, SHAPE_TRIANGLE } Shape;

// #region hit
typedef struct Hit {
    float distance;  // along the ray; INFINITY when nothing was hit
    Shape shape;
    int index;  // of the sphere, plane or triangle
#if TRIANGLE_COUNT > 0
    float2 barycentric;  // the weights of the triangle's second and third vertex
#endif
} Hit;

// Where and what a ray has hit, as shading wants it: both normals face the eye.
typedef struct Surface {
    float3 position;
    float3 normal;            // for shading; unit length
    float3 geometric_normal;  // unit length
    bool from_behind;         // seen from inside a sphere or a mesh, or from under a plane
    int material;
    float offset;  // how far off the surface a new ray starts
#if HAS_TEXTURES
    float2 texture_coordinates;
#endif
} Surface;
// #endregion hit

// #region offset
// Rounding moves a hit point by a few units in the last place of the largest number that went
// into it, so a ray that leaves starts some thirty units off the surface: in proportion to
// the coordinates, for a scene of any size.
#define ORIGIN_OFFSET 2e-6f

static float origin_offset(const Ray ray, const float distance) {
    const float3 size = fabs(ray.origin);
    return ORIGIN_OFFSET * (max(size.x, max(size.y, size.z)) + distance);
}

// `direction` need not be of unit length: only its side counts.
static float3 origin_off(const Surface *surface, const float3 direction) {
    const float side = dot(surface->geometric_normal, direction) < 0.0f ? -1.0f : 1.0f;
    return surface->position + side * surface->offset * surface->geometric_normal;
}
// #endregion offset
