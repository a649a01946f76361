// SPDX-License-Identifier: MIT
// Exercise 04.3, solved: a second wall for each sphere of glass, whose outside is its inside.

// kernels/each_shape.cl
// #region each_sphere
#define HOLLOW 0.85f  // the inner radius by the outer one

    for (int i = 0; i < scene->sphere_count; ++i) {
        const Sphere sphere = scene->spheres[i];
        keep_closer(closest, intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius),
                    SHAPE_SPHERE, i);
        if (scene->materials[sphere.material].type == MATERIAL_DIELECTRIC) {
            keep_closer(closest,
                        intersect_ray_sphere(ray, XYZ(sphere.center), HOLLOW * sphere.radius),
                        SHAPE_SPHERE, i);
        }
    }
// #endregion each_sphere

// kernels/surface.cl
// #region sphere_surface
// The hit point is put back onto the sphere: far away, the distance alone would miss it.
static void sphere_surface(Surface *surface, const Sphere sphere, const Ray ray, const Hit hit) {
    const float3 center = XYZ(sphere.center);
    const float3 position = ray.origin + hit.distance * ray.direction;
    // A point of the inner wall is far from the outer one.
    const bool inner = distance(position, center) < 0.5f * (1.0f + HOLLOW) * sphere.radius;
    const float radius = inner ? HOLLOW * sphere.radius : sphere.radius;
    const float3 from_center = normalize(position - center);
    surface->normal = inner ? -from_center : from_center;  // out of the glass, so into the cavity
    surface->geometric_normal = surface->normal;
    surface->position = center + radius * from_center;
    surface->material = sphere.material;
    surface->ray_offset =
        error_along(surface->normal, surface->position, (float3)(GAMMA(15.0f) * radius));
}
// #endregion sphere_surface
