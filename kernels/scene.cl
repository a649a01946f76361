// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 02 (materials, lights), 04 (media), 05 (meshes), 06 (textures) and
// 09 (a tree of boxes): the scene, as a kernel's arguments and as one struct to hand on.
//
// The host defines HAS_SPHERES and its like, 0 or 1, for the scene at hand. What a scene has not costs
// nothing: no argument, and where a kernel asks for it, the compiler takes out what is never reached.
#include "ray.cl"

// #region textures
// An image can't be a member of a struct: it is handed on beside the scene.
#if HAS_TEXTURES
#define TEXTURES __read_only image2d_array_t
#else
#define TEXTURES const int
enum { textures };  // to be handed on where a kernel has no such parameter
#endif
// #endregion textures

// #region scene
typedef struct Scene {
    Single4 background;
    __global const Sphere *spheres;
    int sphere_count;
    __global const Plane *planes;
    int plane_count;
    __global const Material *materials;
    uint eye_media;  // that the eye is in
    __global const Light *lights;
    int light_count;
    __global const Triangle *triangles;
    int triangle_count;
    __global const Single4 *triangle_corners;  // three a triangle
    __global const Single4 *vertex_normals;
    __global const Single2 *vertex_texture_coordinates;
    __global const Single4 *vertex_colors;
    __global const Cutout *cutouts;  // of each material
    __global const uchar *alphas;    // of the pictures that cut out
    __global const BvhNode *bvh_nodes;
} Scene;
// #endregion scene
