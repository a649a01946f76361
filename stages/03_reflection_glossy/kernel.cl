// SPDX-License-Identifier: MIT
// Stage 03: mirrors and glossy surfaces. A ray that is reflected is a ray to trace again, and as
// OpenCL C knows no recursion, the rays that wait for their turn are kept on a stack.
#include "each_shape.cl"
#include "closest_hit.cl"
#include "any_hit.cl"
#include "ray_stack.cl"   // new: the rays still to be traced
#include "reflection.cl"  // new: the ray that a mirror sends on
#include "render.cl"      // new: the kernel, from here to stage 08
#include "shade.cl"       // new: what a material does with light
#include "trace.cl"       // new: the loop that takes rays from the stack until none is left
#include "scene_types.h"  // extended: types of material
