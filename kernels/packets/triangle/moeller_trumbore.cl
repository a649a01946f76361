// SPDX-License-Identifier: MIT
// Where rays meet a triangle, with no threshold.
#include "packets/triangle.cl"

static Wide wide_ray_triangle(const WideRays *rays, const TriangleRays *shared, const Scene *scene,
                              const uint index, Wide *b, Wide *c) {
    return wide_moeller_trumbore(rays, scene, index, b, c, 0.0f);
}
