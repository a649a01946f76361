// SPDX-License-Identifier: MIT
// Stage 06: textures. The colour of a surface is read from a picture, at a place that a sphere
// works out and a mesh brings along. A picture's alpha can cut holes into triangles.
#include "each_shape.cl"  // extended: a triangle may not be there
#include "closest_hit.cl"
#include "any_hit.cl"
#include "cutout.cl"               // new: where it is not
#include "filtering/sampler.cl"    // new: four texels, blended by the device
#include "texture.cl"              // new: one array of pictures
#include "texture_coordinates.cl"  // new: longitude and latitude
#include "wrap.cl"                 // new: beyond a picture's edges
#include "ray.cl"                  // extended: a surface knows where on its picture it is
#include "real.cl"                 // extended: two numbers from memory
#include "render.cl"               // extended: the pictures are arguments
#include "scene.cl"                // extended: texture coordinates, colours of vertices, alphas
#include "scene_types.h"           // extended: cut-outs, wraps
#include "shade.cl"                // extended: the texel multiplies the colour
#include "surface.cl"              // extended: texture coordinates
#include "trace.cl"                // extended: the pictures are handed on
#include "triangle.cl"             // extended: texture coordinates, colours of vertices
