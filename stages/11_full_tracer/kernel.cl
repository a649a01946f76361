// SPDX-License-Identifier: MIT
// Stage 11: the full tracer. Light bends into closed meshes now, since a tree makes their many rays
// cheap; and none is followed that no eye could see.
#include "packets/render.cl"
#include "dielectric.cl"  // extended: smooth meshes, whose normal may lean away
#include "ray_counts.cl"  // extended: rays too weak to matter
#include "ray_stack.cl"   // extended: rays too weak to matter
#include "scene_types.h"  // extended: their weight is counted
