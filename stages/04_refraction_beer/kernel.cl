// SPDX-License-Identifier: MIT
// Stage 04: glass. A hit now spawns two rays, one reflected and one refracted, and on its way
// through glass a ray loses light by Beer's law.
#include "each_shape.cl"
#include "closest_hit.cl"
#include "any_hit.cl"
#include "render.cl"            // extended: what the eye is in
#include "dielectric.cl"        // new: Snell, total internal reflection
#include "media.cl"             // new: glass in glass
#include "fresnel/schlick.cl"   // new: how much is reflected
#include "transmission/exp.cl"  // new: Beer's law
#include "ray_stack.cl"         // extended: a ray knows the medium that it runs in
#include "scene.cl"             // extended: what the eye is in
#include "shade.cl"             // extended: the dielectric is one more material
#include "trace.cl"             // extended: what the eye is in
