// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 02 (lines), 05 (triangles), 06 (textures), 09 (fused
// products) and 10 (the smaller and the larger): what is sent through the scene, and what comes back.
#include "real.cl"
#include "normalise/exact.cl"

// #region fused
// a * b + c, rounded once where the device does that in hardware: fma() in software takes many times as
// long.
#define FUSED(a, b, c) (HAS_FMA ? fma(a, b, c) : (a) * (b) + (c))

// The second where the first is not a number. Compare and select are an instruction each; fmin and fmax are
// more.
#define MIN(a, b) ((a) < (b) ? (a) : (b))
#define MAX(a, b) ((a) > (b) ? (a) : (b))

// A component of a direction that is smaller is taken for this: its inverse is finite.
#define SMALLEST_DIRECTION 1e-24f
// #endregion fused

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
    int index;           // of the sphere, plane or triangle
    float2 barycentric;  // the weights of the triangle's second and third vertex
} Hit;

// Where and what a ray has hit, as shading wants it: both normals face the eye.
typedef struct Surface {
    float3 position;
    float3 normal;            // for shading; unit length
    float3 geometric_normal;  // unit length
    bool from_behind;         // seen from inside a sphere or a mesh, or from under a plane
    int material;
    float ray_offset;  // how far off the surface a new ray starts
    float2 texture_coordinates;
} Surface;
// #endregion hit

// #region keep_closer
// Whether what is at `distance` is nearer than all before it.
static bool keep_closer(Hit *closest, const float distance, const Shape shape, const int index) {
    if (!(distance < closest->distance)) {
        return false;
    }
    closest->distance = distance;
    closest->shape = shape;
    closest->index = index;
    return true;
}
// #endregion keep_closer
