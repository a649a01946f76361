// SPDX-License-Identifier: MIT
// Stage 06: textures. The colour of a surface is read from a picture, at a place that a sphere
// works out and a mesh brings along.
#include "closest_hit.cl"  // extended: a surface knows where on its picture it is
#include "render.cl"
#include "texture.cl"              // new: one array of pictures, filtered by the device
#include "texture_coordinates.cl"  // new: longitude and latitude
#include "trace.cl"                // extended: the texel multiplies the colour
