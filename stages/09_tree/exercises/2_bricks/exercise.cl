// SPDX-License-Identifier: MIT
// #stub
// Exercise 09.2: each leaf as its bounding box.
// #solution
// Exercise 09.2, solved: a brick is entered with the last of its slabs, and left with the first.
// #end

// kernels/tree.cl
// #region leaf
// #stub
// To where the ray enters the box, INFINITY where it does not; and the axis across which it does.
static float enter_brick(const Ray ray, const float3 low, const float3 high, int *axis) {
    *axis = 0;
    return INFINITY;  // your turn
}
// #solution
// To where the ray enters the box, INFINITY where it does not; and the axis across which it does (Kay and Kajiya, Ray
// Tracing Complex Scenes, 1986).
static float enter_brick(const Ray ray, const float3 low, const float3 high, int *axis) {
    const float3 to_low = (low - ray.origin) / ray.direction;
    const float3 to_high = (high - ray.origin) / ray.direction;
    const float3 enters = fmin(to_low, to_high);
    const float3 leaves = fmax(to_low, to_high);
    const float enter = fmax(enters.x, fmax(enters.y, enters.z));
    const float leave = fmin(leaves.x, fmin(leaves.y, leaves.z));
    *axis = enter == enters.x ? 0 : enter == enters.y ? 1 : 2;
    return enter <= leave && enter > 0.0f ? enter : INFINITY;
}
// #end

// Leaves of spheres are drawn as ever.
static void try_leaf(const Scene *scene, const Ray ray, const int first, const int count, Hit *closest) {
    for (int i = first; i < first - count; ++i) {
        const Sphere sphere = scene->spheres[i];
        keep_closer(closest, intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius), SHAPE_SPHERE, i);
    }
    if (count > 0) {
// #stub
        float3 low = (float3)(0.0f);
        float3 high = (float3)(0.0f);  // your turn
// #solution
        float3 low = (float3)(INFINITY);
        float3 high = (float3)(-INFINITY);
        for (int i = first; i < first + count; ++i) {
            for (int corner = 0; corner < 3; ++corner) {
                low = fmin(low, triangle_corner(scene, i, corner));
                high = fmax(high, triangle_corner(scene, i, corner));
            }
        }
// #end
        int axis;
        const float t = enter_brick(ray, low, high, &axis);
        if (keep_closer(closest, t, SHAPE_TRIANGLE, first)) {
            closest->barycentric.x = axis;
        }
    }
}
// #endregion leaf

// kernels/render.cl
// #region render_pixel
    const Ray primary = camera_ray(&camera, pixel);
    const Hit hit = closest_hit(&scene, primary);
    // A brick's hue is by its place among the leaves, so that those of one branch are alike; spheres and planes are grey.
    float3 color = hit.shape == SHAPE_NONE ? (float3)(0.0f) : (float3)(0.3f);
    if (hit.shape == SHAPE_TRIANGLE) {
        const float hue = 6.0f * hit.index / scene.triangle_count;
        const float3 rgb = {fabs(hue - 3.0f) - 1.0f, 2.0f - fabs(hue - 2.0f), 2.0f - fabs(hue - 4.0f)};
        const float side = 1.0f - 0.25f * hit.barycentric.x;
        color = side * clamp(rgb, (float3)(0.0f), (float3)(1.0f));
    }
    write_pixel(image, camera.size.x, pixel, color);
// #endregion render_pixel
