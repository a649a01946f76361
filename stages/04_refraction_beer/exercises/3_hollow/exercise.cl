// SPDX-License-Identifier: MIT
// #stub
// Exercise 04.3: where a ray meets a sphere of glass, and what is there.
// #solution
// Exercise 04.3, solved: a second wall for each sphere of glass, whose outside is its inside.
// #end

// kernels/each_shape.cl
// #region each_sphere
#define HOLLOW 0.85f  // the inner radius by the outer one

    for (int i = 0; i < scene->sphere_count; ++i) {
        const Sphere sphere = scene->spheres[i];
// #stub
        keep_closer(closest, intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius),
                    SHAPE_SPHERE, i);  // your turn
// #solution
        keep_closer(closest, intersect_ray_sphere(ray, XYZ(sphere.center), sphere.radius),
                    SHAPE_SPHERE, i);
        if (scene->materials[sphere.material].type == MATERIAL_DIELECTRIC) {
            keep_closer(closest,
                        intersect_ray_sphere(ray, XYZ(sphere.center), HOLLOW * sphere.radius),
                        SHAPE_SPHERE, i);
        }
// #end
    }
// #endregion each_sphere

// kernels/surface.cl
// #region sphere_surface
// The hit point is put back onto the sphere: far away, the distance alone would miss it.
static void sphere_surface(Surface *surface, const Sphere sphere, const Ray ray, const Hit hit) {
    const float3 center = XYZ(sphere.center);
    const float3 position = ray.origin + hit.distance * ray.direction;
// #stub
    surface->normal = normalize(position - center);  // your turn
    surface->geometric_normal = surface->normal;
    surface->position = center + sphere.radius * surface->normal;
    surface->material = sphere.material;
    surface->ray_offset = error_along(surface->normal, surface->position,
                                  (float3)(GAMMA(15.0f) * sphere.radius));
// #solution
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
// #end
}
// #endregion sphere_surface
