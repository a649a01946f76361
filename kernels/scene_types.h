// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 02 (materials, lights), 03 (types of material), 05
// (triangles), 06 (cut-outs), 09 (a tree), 10 (tiles) and 11 (importance cutoff): the structs that the host
// fills and the kernels read. This file is compiled as C++ and as OpenCL C. float4 only, never float3: its
// size and alignment are the same everywhere. Lengths in scene units, world space, right-handed, y
// up; colours linear.
#ifndef STAGELIGHT_SCENE_TYPES_H
#define STAGELIGHT_SCENE_TYPES_H

#ifdef __OPENCL_VERSION__
#if !METHOD_MATH_MAD
#pragma OPENCL FP_CONTRACT OFF
#endif
#if METHOD_MATH_FP64
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#endif
#else
#include <cstddef>

#include <CL/cl_platform.h>

namespace stagelight::device {
using double2 = cl_double2;
using double4 = cl_double4;
using float2 = cl_float2;
using float4 = cl_float4;
using int2 = cl_int2;
using uint = cl_uint;
using ushort2 = cl_ushort2;
using uchar = cl_uchar;
#endif

// #region camera
// The point (x, y) of the picture, in pixels from its upper left corner, is seen in the
// direction corner + x * right + y * down (not of unit length).
typedef struct Camera {
    float4 position;
    float4 corner;
    float4 right;   // one pixel to the right
    float4 down;    // one pixel down
    float2 sample;  // the point of a pixel that is sampled, in [0, 1)
    int2 size;      // the picture's, pixels
    uint media;     // the dielectrics that the eye is in, a bit for each
} Camera;

#if !defined(__OPENCL_VERSION__) || METHOD_MATH_FP64
// The same where the kernel calculates in double: a direction that was rounded on its way would be
// off by as much as float is.
typedef struct DoubleCamera {
    double4 position;
    double4 corner;
    double4 right;
    double4 down;
    double2 sample;
    int2 size;
    uint media;
} DoubleCamera;
#endif
// #endregion camera

typedef enum MaterialType { MATERIAL_DIFFUSE, MATERIAL_MIRROR, MATERIAL_GLOSSY, MATERIAL_DIELECTRIC } MaterialType;

// #region material
typedef struct GlossyMaterial {
    float specularity;  // the reflected share, [0, 1]
} GlossyMaterial;

typedef struct DielectricMaterial {
    float4 absorption;  // Beer's coefficient, per scene unit; w unused
    float ior;          // index of refraction, > 0
    uint medium;        // its bit, where dielectrics meet
} DielectricMaterial;

// What lies beyond the edges of a picture.
typedef enum WrapType { WRAP_REPEAT, WRAP_CLAMP, WRAP_MIRROR } WrapType;

// A type and what only that type needs (paper, section 2).
typedef struct Material {
    float4 color;  // linear, [0, 1]; w unused
    union {
        GlossyMaterial glossy;
        DielectricMaterial dielectric;
    } as;
    ushort2 texture_size;   // texels, without the border
    ushort2 texture_place;  // of the picture's first texel on its layer
    short texture;          // layer of the texture array, -1 for none
    uchar wrap_u, wrap_v;   // WrapType
    int type;               // MaterialType
} Material;

// Beside each Material, where a scene has any that is cut out.
typedef struct Cutout {
    uint first;    // of its picture's alphas, row by row
    float cutoff;  // of 255: where the picture's alpha is less, a triangle is not there
} Cutout;
// #endregion material

typedef enum LightType { LIGHT_POINT, LIGHT_DIRECTIONAL } LightType;

typedef struct PointLight {
    float4 position;  // w unused
    float range;      // no light beyond; INFINITY for none
} PointLight;

typedef struct DirectionalLight {
    float4 direction;  // the way the light travels, unit length; w unused
} DirectionalLight;

typedef struct Light {
    float4 color;  // colour times intensity; w unused
    union {
        PointLight point;
        DirectionalLight directional;
    } as;
    int type;  // LightType
} Light;

typedef struct Sphere {
    float4 center;  // w unused
    float radius;
    int material;
} Sphere;

// All p with dot(normal, p) = offset.
typedef struct Plane {
    float4 normal;  // unit length; w unused
    float offset;
    int material;
} Plane;

// Three indices into the vertex buffers, counter-clockwise seen from outside.
typedef struct Triangle {
    uint vertices[3];
    int material;
} Triangle;

// #region bvh_node
// Four boxes around shapes, side by side, so that all are tried at once.
typedef struct BvhNode {
    float4 planes[6];  // low x, y, z, high x, y, z of each child
    int first[4];      // of a leaf, the first of its shapes; else the child's node
    int count[4];      // of a leaf, how many triangles it has, or minus how many spheres; else 0
} BvhNode;
// #endregion bvh_node

// Of a coordinate: how far rounding may move what is measured from it, and some more. Boxes are
// padded by it on the host, and on the device for where the ray starts (kernels/tree.cl,
// enter_boxes).
#define SLAB_PADDING 2.3841858e-7f

// Of the tile that a packet of `width` rays draws, how many pixels are in a row: as square as can
// be. And of the block that a work-item draws, how many packets are in a row, and in a column.
#define TILE_WIDTH_OF(width) ((width) < 8 ? 2 : 4)
#define PACKETS_IN_ROW 2

// How many rays of a kind were traced, how many the depth limit dropped, and how many were cut off:
// one a row of the picture, so that no count outgrows 32 bits and few work-items meet at one.
typedef struct RayCounts {
    uint shadow;
    uint reflection;
    uint refraction;
    uint dropped;
    uint cut_off;         // too weak to be traced
    uint cut_off_weight;  // their sum, CUT_OFF_WEIGHT_ONE for all of a pixel; of a row the largest
                          // pixel's
} RayCounts;
#define CUT_OFF_WEIGHT_ONE 16777216.0f

#ifndef __OPENCL_VERSION__
static_assert(sizeof(Camera) == 96 && offsetof(Camera, sample) == 64 && offsetof(Camera, size) == 72
              && offsetof(Camera, media) == 80);
static_assert(sizeof(DoubleCamera) == 160 && offsetof(DoubleCamera, sample) == 128
              && offsetof(DoubleCamera, size) == 144 && offsetof(DoubleCamera, media) == 152);
static_assert(sizeof(Material) == 64 && offsetof(Material, as) == 16 && offsetof(Material, texture_size) == 48
              && offsetof(Material, texture_place) == 52 && offsetof(Material, texture) == 56
              && offsetof(Material, wrap_u) == 58 && offsetof(Material, type) == 60
              && offsetof(DielectricMaterial, ior) == 16 && offsetof(DielectricMaterial, medium) == 20);
static_assert(sizeof(Cutout) == 8 && offsetof(Cutout, cutoff) == 4);
static_assert(sizeof(Light) == 64 && offsetof(Light, as) == 16 && offsetof(Light, type) == 48
              && offsetof(PointLight, range) == 16);
static_assert(sizeof(Sphere) == 32 && offsetof(Sphere, radius) == 16 && offsetof(Sphere, material) == 20);
static_assert(sizeof(Plane) == 32 && offsetof(Plane, offset) == 16 && offsetof(Plane, material) == 20);
static_assert(sizeof(BvhNode) == 128 && offsetof(BvhNode, first) == 96);
static_assert(sizeof(Triangle) == 16 && offsetof(Triangle, material) == 12);
static_assert(sizeof(RayCounts) == 24 && offsetof(RayCounts, cut_off) == 16);
}  // namespace stagelight::device
#endif

#endif
