// SPDX-License-Identifier: MIT
// Where rays meet a triangle, with a threshold as in the code of Möller and Trumbore's paper (theirs is 1e-6) and
// in much since. But the determinant shrinks with the square of a triangle's size, and small meshes vanish.
#include "packets/triangle.cl"

static Wide wide_ray_triangle(const WideRays *rays, const TriangleRays *shared, const Scene *scene,
                              const uint index, Wide *b, Wide *c) {
    return wide_moeller_trumbore(rays, scene, index, b, c, 1e-5f);
}
