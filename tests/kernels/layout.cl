// SPDX-License-Identifier: MIT
// How the structs of scene_types.h lie on the device, in the order of layout_test.cpp.
#include "scene_types.h"

#define OFFSET(type, member) ((uint)(size_t) & ((__private type *)0)->member)

__kernel void layout(__global uint *results, __global const uint *indices) {
    const uint layout[] = {
        sizeof(Camera),
        OFFSET(Camera, position),
        OFFSET(Camera, corner),
        OFFSET(Camera, right),
        OFFSET(Camera, down),
        OFFSET(Camera, sample),
        OFFSET(Camera, size),
        sizeof(GlossyMaterial),
        OFFSET(GlossyMaterial, specularity),
        sizeof(DielectricMaterial),
        OFFSET(DielectricMaterial, absorption),
        OFFSET(DielectricMaterial, ior),
        sizeof(Material),
        OFFSET(Material, color),
        OFFSET(Material, as.glossy),
        OFFSET(Material, as.dielectric),
        OFFSET(Material, texture_size),
        OFFSET(Material, texture),
        OFFSET(Material, type),
        sizeof(PointLight),
        OFFSET(PointLight, position),
        OFFSET(PointLight, range),
        sizeof(DirectionalLight),
        OFFSET(DirectionalLight, direction),
        sizeof(Light),
        OFFSET(Light, color),
        OFFSET(Light, as.point),
        OFFSET(Light, as.directional),
        OFFSET(Light, type),
        sizeof(Sphere),
        OFFSET(Sphere, center),
        OFFSET(Sphere, radius),
        OFFSET(Sphere, material),
        sizeof(Plane),
        OFFSET(Plane, normal),
        OFFSET(Plane, offset),
        OFFSET(Plane, material),
        sizeof(Triangle),
        OFFSET(Triangle, vertices),
        OFFSET(Triangle, material),
        sizeof(BvhNode),
        OFFSET(BvhNode, planes),
        OFFSET(BvhNode, first),
        OFFSET(BvhNode, count),
        sizeof(RayCounts),
        OFFSET(RayCounts, shadow),
        OFFSET(RayCounts, reflection),
        OFFSET(RayCounts, refraction),
        OFFSET(RayCounts, dropped),
        OFFSET(RayCounts, cut_off),
        OFFSET(RayCounts, cut_off_weight),
    };
    const uint count = sizeof(layout) / sizeof(layout[0]);
    const size_t i = get_global_id(0);
    results[i] = indices[i] < count ? layout[indices[i]] : 0;
}
