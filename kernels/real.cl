// SPDX-License-Identifier: MIT
// Introduced by stage 01; extended by 06 (textures), 09 (a tree) and 10 (masks): the numbers that are calculated
// with. With --method math=fp64, where it says float it is double: the camera and what kernels
// calculate, but not what lies in memory or comes from an image.
#include "scene_types.h"

// #region real
// As they lie in memory.
typedef float Single;
typedef float2 Single2;
typedef float4 Single4;

#if METHOD_MATH_FP64
#define Camera DoubleCamera
#define float double
#define float2 double2
#define float3 double3
#define float4 double4
#define float8 double8
#define float16 double16
#define TO_REAL convert_double
#define AS_REAL as_double
// What comparing vectors gives is as wide as their numbers.
#define LANE_INT long
#define AS_LANE_INT as_long
#define TO_LANE_INT convert_long
#define PI M_PI
// OpenCL's native functions are for float alone.
#define NATIVE_RSQRT rsqrt
#define NATIVE_EXP exp
#else
#define TO_REAL convert_float
#define AS_REAL as_float
#define LANE_INT int
#define AS_LANE_INT as_int
#define TO_LANE_INT convert_int
#define PI M_PI_F
#define NATIVE_RSQRT native_rsqrt
#define NATIVE_EXP native_exp
#endif

// From memory.
#define JOIN_NAMES(a, b) a##b
#define JOIN(a, b) JOIN_NAMES(a, b)
#define XY(v) JOIN(TO_REAL, 2)(v)
#define XYZ(v) JOIN(TO_REAL, 3)((v).xyz)
#define XYZW(v) JOIN(TO_REAL, 4)(v)
// #endregion real
