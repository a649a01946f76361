// SPDX-License-Identifier: MIT
// #stub
// Exercise 09.3: what lies before a plane is not there.
// #solution
// Exercise 09.3, solved: a hit that is cut away is none, and a sphere has a second one.
// #end

// kernels/tree.cl
// #region leaf
#define CUT_NORMAL (float3)(-0.28f, 0.0f, 0.96f)  // unit length
#define CUT_OFFSET 0.1f

// What is beyond the plane is not there.
static bool is_cut_away(const float3 point) {
// #stub
    return false;  // your turn
// #solution
    return dot(CUT_NORMAL, point) > CUT_OFFSET;
// #end
}

// #stub
// #solution
// A distance to what is there; INFINITY for none.
static float still_there(const Ray ray, const float t) {
    return t > 0.0f && t < INFINITY && !is_cut_away(ray.origin + t * ray.direction) ? t : INFINITY;
}

// #end
static void try_leaf(const Scene *scene, const Ray ray, const int first, const int count, Hit *closest) {
    if (HAS_SPHERES) {
        for (int i = first; i < first - count; ++i) {
// #stub
            const Sphere sphere = scene->spheres[i];
            const float t = intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius);
            keep_closer(closest, t, SHAPE_SPHERE, i);  // your turn
// #solution
            // The point nearest the centre is half-way between the two walls.
            const float3 center = XYZ(scene->spheres[i].center);
            const float wall = intersect_ray_sphere(ray, center, scene->spheres[i].radius);
            const float other_wall = 2.0f * dot(center - ray.origin, ray.direction) - wall;
            const float t = fmin(still_there(ray, wall), still_there(ray, other_wall));
            keep_closer(closest, t, SHAPE_SPHERE, i);
// #end
        }
    }
    if (HAS_TRIANGLES) {
        for (int i = first; i < first + count; ++i) {
            float2 barycentric;
// #stub
            const float t = intersect_triangle(ray, scene, i, &barycentric);
            // your turn
// #solution
            const float t = still_there(ray, intersect_triangle(ray, scene, i, &barycentric));
// #end
            closest->barycentric = keep_closer(closest, t, SHAPE_TRIANGLE, i) ? barycentric : closest->barycentric;
        }
    }
}
// #endregion leaf
