// SPDX-License-Identifier: MIT
// Exercise 04.3: where a ray meets a sphere of glass, and what is there.

// kernels/each_shape.cl
// #region each_sphere
#define HOLLOW 0.85f  // the inner radius by the outer one

    for (int i = 0; i < scene->sphere_count; ++i) {
        const Sphere sphere = scene->spheres[i];
        keep_closer(closest, intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius),
                    SHAPE_SPHERE, i);  // your turn
    }
// #endregion each_sphere

// kernels/surface.cl
// #region sphere_surface
// The hit point is put back onto the sphere: far away, the distance alone would miss it.
static void sphere_surface(Surface *surface, const Sphere sphere, const Ray ray, const Hit hit) {
    const float3 center = XYZ(sphere.center);
    const float3 position = ray.origin + hit.distance * ray.direction;
    surface->normal = normalize(position - center);  // your turn
    surface->geometric_normal = surface->normal;
    surface->position = center + sphere.radius * surface->normal;
    surface->material = sphere.material;
    surface->ray_offset = error_along(surface->normal, surface->position,
                                  (float3)(GAMMA(15.0f) * sphere.radius));
}
// #endregion sphere_surface
