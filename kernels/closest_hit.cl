// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 05 (triangles), 06 (texture coordinates) and 09 (a tree of
// boxes): what a ray hits first, and what is there.
#include "plane.cl"
#include "scene.cl"
#include "sphere.cl"
#if TRIANGLE_COUNT > 0
#include "triangle.cl"
#endif
#if BVH_DEPTH > 0
#include "bvh.cl"
#endif
#if HAS_TEXTURES
#include "texture_coordinates.cl"
#endif

// #region closest_hit
static void keep_closer(Hit *closest, const float distance, const Shape shape, const int index) {
    if (distance < closest->distance) {
        closest->distance = distance;
        closest->shape = shape;
        closest->index = index;
    }
}

static Hit closest_hit(const Scene *scene, const Ray ray) {
    Hit closest;
    closest.distance = INFINITY;
    closest.shape = SHAPE_NONE;
#if SPHERE_COUNT > 0
    for (int i = 0; i < SPHERE_COUNT; ++i) {
        const Sphere sphere = scene->spheres[i];
        keep_closer(&closest, intersect_ray_sphere(ray, sphere.center.xyz, sphere.radius),
                    SHAPE_SPHERE, i);
    }
#endif
#if PLANE_COUNT > 0
    for (int i = 0; i < PLANE_COUNT; ++i) {
        const Plane plane = scene->planes[i];
        keep_closer(&closest, intersect_ray_plane(ray, plane.normal.xyz, plane.offset), SHAPE_PLANE,
                    i);
    }
#endif
#if BVH_DEPTH > 0
    closest_triangle(scene, ray, &closest);
#elif TRIANGLE_COUNT > 0
    for (int i = 0; i < TRIANGLE_COUNT; ++i) {
        float2 barycentric;
        const float distance =
            intersect_ray_triangle(ray, triangle_positions(scene, i), &barycentric);
        if (distance < closest.distance) {
            closest.barycentric = barycentric;
        }
        keep_closer(&closest, distance, SHAPE_TRIANGLE, i);
    }
#endif
    return closest;
}
// #endregion closest_hit

// #region surface_at
#if SPHERE_COUNT > 0
// The hit point is put back onto the sphere: far away, the distance alone would miss it.
static void sphere_surface(Surface *surface, const Sphere sphere, const Ray ray, const Hit hit) {
    const float3 center = sphere.center.xyz;
    const float3 position = ray.origin + hit.distance * ray.direction;
    surface->normal = normalize(position - center);
    surface->geometric_normal = surface->normal;
    surface->position = center + sphere.radius * surface->normal;
    surface->material = sphere.material;
#if HAS_TEXTURES
    surface->texture_coordinates = sphere_texture_coordinates(surface->normal);
#endif
}
#endif

#if PLANE_COUNT > 0
static void plane_surface(Surface *surface, const Plane plane, const Ray ray, const Hit hit) {
    surface->position = ray.origin + hit.distance * ray.direction;
    surface->normal = plane.normal.xyz;
    surface->geometric_normal = plane.normal.xyz;
    surface->material = plane.material;
#if HAS_TEXTURES
    surface->texture_coordinates = (float2)(0.0f);  // a plane has none
#endif
}
#endif

// The surface at a hit, its normals turned to the side that the ray came from.
static Surface surface_at(const Scene *scene, const Ray ray, const Hit hit) {
    Surface surface;
    switch (hit.shape) {
#if SPHERE_COUNT > 0
    case SHAPE_SPHERE:
        sphere_surface(&surface, scene->spheres[hit.index], ray, hit);
        break;
#endif
#if PLANE_COUNT > 0
    case SHAPE_PLANE:
        plane_surface(&surface, scene->planes[hit.index], ray, hit);
        break;
#endif
#if TRIANGLE_COUNT > 0
    case SHAPE_TRIANGLE:
        triangle_surface(&surface, scene, hit);
        break;
#endif
    default:
        break;
    }
    surface.from_behind = dot(surface.geometric_normal, ray.direction) > 0.0f;
    if (surface.from_behind) {
        surface.normal = -surface.normal;
        surface.geometric_normal = -surface.geometric_normal;
    }
    surface.offset = origin_offset(ray, hit.distance);
    return surface;
}
// #endregion surface_at
