// SPDX-License-Identifier: MIT
// Stage 09: acceleration. What is not in a box that a ray meets need not be tried, and rays that run
// side by side are traced side by side. New: beam.cl has the boxes and how they are entered, bvh.cl the
// walk down the tree of them.
#include "wide.cl"          // new: a number for each of many rays
#include "wide_hit.cl"      // new: the tests of spheres and planes, for many rays
#include "wide_light.cl"    // new: the lights, for many points
#include "wide_render.cl"   // new: a block of pixels for a work-item
#include "wide_surface.cl"  // new: fetched one by one, worked out together
#include "wide_trace.cl"    // new: what is shaded one by one, and traced together
