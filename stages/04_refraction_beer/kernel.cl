// SPDX-License-Identifier: MIT
// Stage 04: glass. A hit now spawns two rays, one reflected and one refracted, and on its way
// through glass a ray loses light by Beer's law.
#include "dielectric.cl"  // new: Snell, total internal reflection, Beer
#include "fresnel.cl"     // new: Schlick
#include "ray_stack.cl"   // extended: a ray knows the medium that it runs in
#include "render.cl"
#include "trace.cl"  // extended: the dielectric is one more material
