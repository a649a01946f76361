// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 02 (materials, lights), 05 (meshes), 06 (textures),
// 09 (a tree of boxes): the scene, as a kernel's arguments and as one struct to hand on.
//
// The host defines SPHERE_COUNT and its like for the scene at hand. A name that it left out
// counts as 0, and what a scene has not costs nothing: no argument, no loop, no branch.
#include "ray.cl"

// #region storage
// What meshes are made of takes half the bits where the host says so. The type half is for pointers only.
#if STORAGE_IS_HALF
typedef HalfFacet StoredFacet;
typedef half StoredNormal;
#define LOAD_NORMAL(normals, index) XYZ(vload_half4(index, normals))
#define LOAD_COORDINATES(corner) XYZ(vload_half3(0, (__global const half *)(corner)))
#define LOAD_NUMBER(numbers, index) vload_half(index, (__global const half *)(numbers))
#else
typedef Facet StoredFacet;
typedef Single4 StoredNormal;
#define LOAD_NORMAL(normals, index) XYZ((normals)[index])
#define LOAD_COORDINATES(corner) XYZ(vload3(0, corner))
#define LOAD_NUMBER(numbers, index) (numbers)[index]
#endif
// #endregion storage

// #region scene_fields
// #region sphere_fields
#if SPHERE_COUNT > 0
#define SPHERE_FIELDS(FIELD) FIELD(__global const Sphere *, spheres)
#else
#define SPHERE_FIELDS(FIELD)
#endif
// #endregion sphere_fields

#if PLANE_COUNT > 0
#define PLANE_FIELDS(FIELD) FIELD(__global const Plane *, planes)
#else
#define PLANE_FIELDS(FIELD)
#endif

#if MATERIAL_COUNT > 0
#define MATERIAL_FIELDS(FIELD) FIELD(__global const Material *, materials)
#else
#define MATERIAL_FIELDS(FIELD)
#endif

#if LIGHT_COUNT > 0
#define LIGHT_FIELDS(FIELD) FIELD(__global const Light *, lights)
#else
#define LIGHT_FIELDS(FIELD)
#endif

#if TRIANGLE_COUNT > 0
#define MESH_FIELDS(FIELD)                      \
    FIELD(__global const Triangle *, triangles) \
    FIELD(__global const StoredNormal *, vertex_normals)
#else
#define MESH_FIELDS(FIELD)
#endif

#if HAS_FACET_MAPS
#define FACET_MAP_FIELDS(FIELD) FIELD(__global const FacetMap *, facet_maps)
#else
#define FACET_MAP_FIELDS(FIELD)
#endif

#if BVH_WIDTH > 0
#define CORNER_FIELDS(FIELD)                   \
    FIELD(__global const StoredFacet *, facets) \
    FIELD(__global const BvhNode *, bvh_nodes)  \
    FACET_MAP_FIELDS(FIELD)
#elif TRIANGLE_COUNT > 0
#define CORNER_FIELDS(FIELD) FIELD(__global const Single4 *, vertex_positions)
#else
#define CORNER_FIELDS(FIELD)
#endif

#if HAS_MESH_TEXTURES
#define MESH_TEXTURE_FIELDS(FIELD) FIELD(__global const Single2 *, vertex_texture_coordinates)
#else
#define MESH_TEXTURE_FIELDS(FIELD)
#endif

#define SCENE_FIELDS(FIELD) \
    SPHERE_FIELDS(FIELD)    \
    PLANE_FIELDS(FIELD)     \
    MATERIAL_FIELDS(FIELD)  \
    LIGHT_FIELDS(FIELD)     \
    MESH_FIELDS(FIELD)      \
    CORNER_FIELDS(FIELD)    \
    MESH_TEXTURE_FIELDS(FIELD)
// #endregion scene_fields

// #region textures
// An image can't be a member of a struct: it is handed on beside the scene.
#if HAS_TEXTURES
#define TEXTURE_PARAMETER , __read_only image2d_array_t textures
#define TEXTURE_ARGUMENT , textures
#else
#define TEXTURE_PARAMETER
#define TEXTURE_ARGUMENT
#endif
// #endregion textures

// #region scene
#define AS_MEMBER(type, name) type name;
#define AS_PARAMETER(type, name) , type name
#define AS_ARGUMENT(type, name) , name

typedef struct Scene {
    Single4 background;
    SCENE_FIELDS(AS_MEMBER)
} Scene;

#define SCENE_PARAMETERS const Single4 background SCENE_FIELDS(AS_PARAMETER) TEXTURE_PARAMETER
#define SCENE_ARGUMENTS \
    { background SCENE_FIELDS(AS_ARGUMENT) }
// #endregion scene
