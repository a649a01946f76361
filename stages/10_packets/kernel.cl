// SPDX-License-Identifier: MIT
// Stage 10: packets. Rays that run side by side are traced side by side, and four packets of them go
// down the tree as one beam. Where a work-item has one ray, as on a GPU, the kernel is that of stage 09.
//
// Part 1: a number for each of many rays.
#include "packets/wide.cl"                // new: the numbers
#include "packets/normalise/exact.cl"     // new: the directions of vectors
#include "packets/origin.cl"              // new: where many rays start
#include "packets/origin/error_bound.cl"  // new: how far off their surfaces rays start
#include "ray.cl"                         // extended: the smaller and the larger of two
#include "real.cl"                        // extended: whole numbers as wide
#include "scene_types.h"                  // extended: how the pixels of a packet lie
// Part 2: a block of pixels for a work-item.
#include "packets/render.cl"  // new: the kernel
#include "packets/trace.cl"   // new: what is shaded one by one, and traced together
// Part 3: what many rays meet.
#include "packets/hit.cl"            // new: what they hit, and planes
#include "packets/light.cl"          // new: the lights, for many points
#include "packets/sphere.cl"         // new: many lines and a sphere
#include "packets/sphere/haines.cl"  // new: many rays and a sphere
#include "packets/surface.cl"        // new: fetched one by one, worked out together
// Part 4: a tree walked by a packet.
#include "packets/box.cl"            // new: where many rays enter a box
#include "packets/triangle.cl"       // new: what the tests of many triangles share
#include "packets/triangle/woop.cl"  // new: where many rays meet a triangle, watertight
#include "packets/walk.cl"           // new: the walk
// Part 5: the beam.
#include "packets/beam.cl"       // new: the bounds of all packets, and where they enter boxes
#include "packets/walk/beam.cl"  // new: all packets together, then each by itself
