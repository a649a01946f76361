// SPDX-License-Identifier: MIT
// The functions of stage 01: a sphere is its centre and radius, a plane its normal and offset.
#include "camera.cl"
#include "origin.cl"
#include "plane.cl"
#include "sphere.cl"

__kernel void ray_sphere(__global float *distances, __global const float4 *origins,
                         __global const float4 *directions, __global const float4 *spheres) {
    const size_t i = get_global_id(0);
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    distances[i] = intersect_ray_sphere(ray, spheres[i].xyz, spheres[i].w);
}

__kernel void line_sphere(__global int *meets, __global const float4 *origins,
                          __global const float4 *destinations, __global const float4 *spheres) {
    const size_t i = get_global_id(0);
    const Line line = {origins[i].xyz, destinations[i].xyz};
    meets[i] = intersect_line_sphere(line, spheres[i].xyz, spheres[i].w);
}

__kernel void ray_plane(__global float *distances, __global const float4 *origins,
                        __global const float4 *directions, __global const float4 *planes) {
    const size_t i = get_global_id(0);
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    distances[i] = intersect_ray_plane(ray, planes[i].xyz, planes[i].w);
}

__kernel void line_plane(__global int *meets, __global const float4 *origins,
                         __global const float4 *destinations, __global const float4 *planes) {
    const size_t i = get_global_id(0);
    const Line line = {origins[i].xyz, destinations[i].xyz};
    meets[i] = intersect_line_plane(line, planes[i].xyz, planes[i].w);
}

__kernel void camera_rays(__global float8 *rays, __global const Camera *cameras,
                          __global const int2 *pixels) {
    const size_t i = get_global_id(0);
    const Camera camera = cameras[i];
    const Ray ray = camera_ray(&camera, pixels[i]);
    rays[i] = (float8)(ray.origin, 0.0f, ray.direction, 0.0f);
}

// The offset in the result's w: that of a hit at `distances` along the ray.
__kernel void origins_off(__global float4 *results, __global const float4 *origins,
                          __global const float4 *directions, __global const float4 *normals,
                          __global const float *distances) {
    const size_t i = get_global_id(0);
    const Ray ray = {origins[i].xyz, directions[i].xyz};
    Surface surface;
    surface.position = ray.origin + distances[i] * ray.direction;
    surface.geometric_normal = normals[i].xyz;
    surface.ray_offset = ray_offset(ray, distances[i], 0.0f);
    results[i] = (float4)(offset_ray_origin(&surface, ray.direction), surface.ray_offset);
}
