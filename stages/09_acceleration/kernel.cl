// SPDX-License-Identifier: MIT
// Stage 09: acceleration. What is not in a box that a ray meets need not be tried, and rays that run
// side by side are traced side by side. New: beam.cl has the boxes and how they are entered, bvh.cl the
// walk down the tree of them.
#include "beam.cl"                        // new: boxes, and how they are entered
#include "box/robust.cl"                  // new: the room that rounding needs
#include "bvh.cl"                         // new: the walk down the tree of boxes
#include "packets/normalise/exact.cl"     // new: the directions of vectors
#include "packets/origin/error_bound.cl"  // new: how far off their surfaces rays start
#include "packets/sphere/haines.cl"       // new: where rays meet a sphere
#include "packets/triangle/woop.cl"       // new: where rays meet a triangle, watertight
#include "wide.cl"                        // new: a number for each of many rays
#include "wide_hit.cl"                    // new: what many rays hit
#include "wide_light.cl"                  // new: the lights, for many points
#include "wide_origin.cl"                 // new: where many rays start
#include "wide_render.cl"                 // new: the kernel, a block of pixels for a work-item
#include "wide_sphere.cl"                 // new: many lines and a sphere
#include "wide_surface.cl"                // new: fetched one by one, worked out together
#include "wide_trace.cl"                  // new: what is shaded one by one, and traced together
#include "wide_triangle.cl"               // new: what the tests of many triangles share
#include "ray.cl"                         // extended: a product and a sum, rounded once
#include "real.cl"                        // extended: whole numbers as wide
#include "scene.cl"                       // extended: a tree of boxes
#include "scene_types.h"                  // extended: corners in the order of the tree
#include "triangle.cl"                    // extended: corners in the order of the tree
