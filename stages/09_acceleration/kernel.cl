// SPDX-License-Identifier: MIT
// Stage 09: a tree of boxes. What is not in a box that a ray meets need not be tried.
#include "wide_render.cl"
