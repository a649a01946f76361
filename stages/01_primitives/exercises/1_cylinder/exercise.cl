// SPDX-License-Identifier: MIT
// #stub
// Exercise 01.1: the tube of the task, among the spheres and planes.
// #solution
// Exercise 01.1, solved: in x and z the tube is a circle and the ray a line; the nearer wall that it meets within the height.
// #end

// stages/01_primitives/kernel.cl
// #region render
#define CYLINDER_BASE (float3)(0.9f, 0.0f, 0.6f)
#define CYLINDER_HEIGHT 1.6f
#define CYLINDER_RADIUS 0.5f

// The distance along the ray, INFINITY where it misses; the unit normal, turned to the eye.
static float intersect_ray_cylinder(const Ray ray, float3 *normal) {
// #stub
    *normal = (float3)(0.0f);
    return INFINITY;  // your turn
// #solution
    const float3 origin = ray.origin - CYLINDER_BASE;
    const float2 from = origin.xz;
    const float2 along = ray.direction.xz;
    const float a = dot(along, along);
    const float b = dot(from, along);
    const float c = dot(from, from) - CYLINDER_RADIUS * CYLINDER_RADIUS;
    const float discriminant = b * b - a * c;
    if (a == 0.0f || discriminant < 0.0f) {
        return INFINITY;
    }
    const float root = sqrt(discriminant);
    for (int side = -1; side <= 1; side += 2) {
        const float t = (side * root - b) / a;
        const float3 point = origin + t * ray.direction;
        if (t > 0.0f && point.y >= 0.0f && point.y <= CYLINDER_HEIGHT) {
            const float3 outward = (float3)(point.x, 0.0f, point.z) / CYLINDER_RADIUS;
            *normal = dot(outward, ray.direction) > 0.0f ? -outward : outward;
            return t;
        }
    }
    return INFINITY;
// #end
}

__kernel void render(PICTURE image, const Camera camera,
#include "scene_parameters.inc"
) {
    const int2 pixel = (int2)(get_global_id(0), get_global_id(1));
    if (pixel.x >= camera.size.x || pixel.y >= camera.size.y) {
        return;
    }
    const Scene scene = {
#include "scene_members.inc"
    };
    const Ray ray = camera_ray(&camera, pixel);
    const Hit hit = closest_hit(&scene, ray);
    float3 color = XYZ(scene.background);
    float3 normal;
    const float distance = intersect_ray_cylinder(ray, &normal);
    if (distance < hit.distance) {
        Surface surface;
        surface.normal = normal;
        color = normals_and_distances(&surface, distance);
    } else if (hit.shape != SHAPE_NONE) {
        const Surface surface = surface_at(&scene, ray, hit);
        color = normals_and_distances(&surface, hit.distance);
    }
    write_pixel(image, camera.size.x, pixel, color);
}
// #endregion render
