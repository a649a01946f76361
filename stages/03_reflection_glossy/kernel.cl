// SPDX-License-Identifier: MIT
// Stage 03: mirrors and glossy surfaces. A ray that is reflected is a ray to trace again, and as
// OpenCL C knows no recursion, the rays that wait for their turn are kept on a stack.
#include "ray_stack.cl"   // new: the rays still to be traced
#include "reflection.cl"  // new: the ray that a mirror sends on
#include "render.cl"      // new: the kernel, the same up to stage 08
#include "trace.cl"       // new: the loop that takes rays from the stack until none is left
