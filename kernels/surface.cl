// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 02 (materials, offsets), 05 (triangles) and 06 (textures): what
// is there where a ray has hit.
#include "origin.cl"
#include "scene.cl"
#include "triangle.cl"
#include "texture_coordinates.cl"

// #region surface_at
// #region sphere_surface
// The hit point is put back onto the sphere: far away, the distance alone would miss it.
static void sphere_surface(Surface *surface, const Sphere sphere, const Ray ray, const Hit hit) {
    const float3 center = XYZ(sphere.center);
    const float3 position = ray.origin + hit.distance * ray.direction;
    surface->normal = normalize(position - center);
    surface->geometric_normal = surface->normal;
    surface->position = center + sphere.radius * surface->normal;
    surface->material = sphere.material;
    surface->ray_offset = error_along(surface->normal, surface->position, (float3)(GAMMA(15.0f) * sphere.radius));
    if (HAS_TEXTURES) {
        surface->texture_coordinates = sphere_texture_coordinates(surface->normal);
    }
}
// #endregion sphere_surface

// Put back onto the plane too, which takes out what the division has left in the distance.
static void plane_surface(Surface *surface, const Plane plane, const Ray ray, const Hit hit) {
    const float3 normal = XYZ(plane.normal);
    const float3 position = ray.origin + hit.distance * ray.direction;
    surface->position = position - (dot(normal, position) - plane.offset) * normal;
    surface->normal = normal;
    surface->geometric_normal = normal;
    surface->material = plane.material;
    surface->ray_offset = error_along(normal, position, (float3)(GAMMA(12.0f)) * fabs(position));
    if (HAS_TEXTURES) {
        surface->texture_coordinates = (float2)(0.0f);  // a plane has none
    }
}

// What can be looked up of a surface. The normals of a triangle are not of unit length yet:
// finish_triangle sees to that.
static Surface fetch_surface(const Scene *scene, const Ray ray, const Hit hit) {
    Surface surface = {0};  // set on every way: LLVM 19, in PoCL 6.0, ends the process over one that is not
    if (HAS_SPHERES && hit.shape == SHAPE_SPHERE) {
        sphere_surface(&surface, scene->spheres[hit.index], ray, hit);
    }
    if (HAS_PLANES && hit.shape == SHAPE_PLANE) {
        plane_surface(&surface, scene->planes[hit.index], ray, hit);
    }
    if (HAS_TRIANGLES && hit.shape == SHAPE_TRIANGLE) {
        fetch_triangle(&surface, scene, hit);
    }
    return surface;
}

// The surface at a hit, its normals turned to the side that the ray came from.
static Surface surface_at(const Scene *scene, const Ray ray, const Hit hit) {
    Surface surface = fetch_surface(scene, ray, hit);
    if (HAS_TRIANGLES && hit.shape == SHAPE_TRIANGLE) {
        finish_triangle(&surface);
    }
    // #region sides
    surface.from_behind = dot(surface.geometric_normal, ray.direction) > 0.0f;
    if (surface.from_behind) {
        surface.normal = -surface.normal;
        surface.geometric_normal = -surface.geometric_normal;
    }
    // #endregion sides
    surface.ray_offset = ray_offset(ray, hit.distance, surface.ray_offset);
    return surface;
}
// #endregion surface_at
