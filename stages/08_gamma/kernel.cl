// SPDX-License-Identifier: MIT
// Stage 08: gamma. The kernel is that of 06: what rays carry, filters blend and lights add up was
// linear light all along. Wrong were its two ends, where pictures come in and go out. Their values
// are not light but light through a curve, which spends 8 bits as the eye would. new:
// transfer_curves.h has the curves. The host decodes each texel on load, and encodes the picture when
// it is written, each of them once.
#include "each_shape.cl"
#include "closest_hit.cl"
#include "any_hit.cl"
#include "render.cl"
