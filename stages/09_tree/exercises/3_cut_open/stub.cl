// SPDX-License-Identifier: MIT
// Exercise 09.3: what lies before a plane is not there.

// kernels/tree.cl
// #region leaf
#define CUT_NORMAL (float3)(-0.28f, 0.0f, 0.96f)  // unit length
#define CUT_OFFSET 0.1f

// What is beyond the plane is not there.
static bool is_cut_away(const float3 point) {
    return false;  // your turn
}

static void try_leaf(const Scene *scene, const Ray ray, const int first, const int count, Hit *closest) {
    if (HAS_SPHERES) {
        for (int i = first; i < first - count; ++i) {
            const Sphere sphere = scene->spheres[i];
            const float t = intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius);
            keep_closer(closest, t, SHAPE_SPHERE, i);  // your turn
        }
    }
    if (HAS_TRIANGLES) {
        for (int i = first; i < first + count; ++i) {
            float2 barycentric;
            const float t = intersect_triangle(ray, scene, i, &barycentric);
            // your turn
            closest->barycentric = keep_closer(closest, t, SHAPE_TRIANGLE, i) ? barycentric : closest->barycentric;
        }
    }
}
// #endregion leaf
