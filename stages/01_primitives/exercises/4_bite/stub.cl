// SPDX-License-Identifier: MIT
// Exercise 01.4: from each sphere another one is taken away.

// kernels/sphere/geometric.cl
// #region ray_sphere
#define BITE_TOWARDS (float3)(0.48f, 0.6f, 0.64f)  // unit length
#define BITE_SHARE 0.7f

// The distance to the nearest wall ahead of what is left of the sphere; INFINITY for none.
static float intersect_ray_sphere(const Ray ray, const float3 center, const float radius) {
    // your turn
    const float3 to_center = center - ray.origin;
    const float nearest = dot(to_center, ray.direction);
    const float3 perpendicular = to_center - nearest * ray.direction;
    const float half_chord_squared = radius * radius - dot(perpendicular, perpendicular);
    if (half_chord_squared < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(half_chord_squared);
    const bool inside = dot(to_center, to_center) < radius * radius;
    const float distance = inside ? nearest + half_chord : nearest - half_chord;
    return distance > 0.0f ? distance : INFINITY;
}
// #endregion ray_sphere

// kernels/surface.cl
// #region sphere_surface
static void sphere_surface(Surface *surface, const Sphere sphere, const Ray ray, const Hit hit) {
    const float3 center = sphere.center.xyz;
    const float3 position = ray.origin + hit.distance * ray.direction;
    surface->normal = normalize(position - center);  // your turn
    surface->position = center + sphere.radius * surface->normal;
    surface->geometric_normal = surface->normal;
    surface->material = sphere.material;
}
// #endregion sphere_surface
