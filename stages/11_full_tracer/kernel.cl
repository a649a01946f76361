// SPDX-License-Identifier: MIT
// Stage 11: the full tracer. Light bends into closed meshes now, since a tree makes their many rays
// cheap; it ends on smooth ones as it would if they were round; and no ray is followed that no eye could see.
#include "packets/render.cl"
#include "dielectric.cl"                 // extended: smooth meshes, whose normal may lean away
#include "terminator/hanika.cl"          // new: how far a smooth mesh is above its facets
#include "packets/terminator/hanika.cl"  // new: how much of the light it gets
#include "packets/light.cl"              // extended: the same
#include "packets/trace.cl"              // extended: light is asked for there
#include "ray_counts.cl"                 // extended: rays too weak to matter
#include "ray_stack.cl"                  // extended: rays too weak to matter
#include "scene_types.h"                 // extended: their weight is counted
