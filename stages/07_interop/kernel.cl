// SPDX-License-Identifier: MIT
// Stage 07: a picture that OpenGL shows. The kernel is that of 06; what it writes to may now be
// an image, and that image may be the texture on the screen.
#include "each_shape.cl"
#include "closest_hit.cl"
#include "any_hit.cl"
#include "render.cl"
#include "picture.cl"  // extended: a pixel goes to a buffer, or to an image
