// SPDX-License-Identifier: MIT
// Where on a picture a point of a sphere lies, and the colour at a place of a picture.
#include "texture_coordinates.cl"
#if HAS_TEXTURES
#include "texture.cl"
#endif
#if HAS_CUTOUTS
#include "cutout.cl"
#endif

__kernel void coordinates(__global float2 *results, __global const float4 *normals) {
    const size_t i = get_global_id(0);
    results[i] = sphere_texture_coordinates(normals[i].xyz);
}

#if HAS_TEXTURES
// `places`: u, v and the index of a material.
__kernel void colors(__global float4 *results, __global const float4 *places,
#include "scene_parameters.inc"
) {
    const Scene scene = {
#include "scene_members.inc"
    };
    const size_t i = get_global_id(0);
    const Material material = scene.materials[convert_int(places[i].z)];
    results[i] = (float4)(texture_color(&material, places[i].xy, textures), 1.0f);
}
#endif

#if HAS_CUTOUTS
// The alpha at such places, from 0 to 1.
__kernel void alphas_at(__global float *results, __global const float4 *places,
#include "scene_parameters.inc"
) {
    const Scene scene = {
#include "scene_members.inc"
    };
    const size_t i = get_global_id(0);
    const int index = convert_int(places[i].z);
    const Material material = scene.materials[index];
    results[i] =
        alpha_at(&scene.alphas[scene.cutouts[index].first], &material, places[i].xy) / 255.0f;
}
#endif
