// SPDX-License-Identifier: MIT
// Stage 10: the full tracer. Light bends into closed meshes now, since a tree makes their many rays
// cheap; and none is followed that has faded.
#include "dielectric.cl"  // extended: smooth meshes, whose normal may lean away
#if METHOD_FRESNEL_EXACT
#include "fresnel.cl"  // new: --method fresnel=exact
#endif
#include "ray_stack.cl"  // extended: rays too weak to matter
#include "wide_render.cl"
