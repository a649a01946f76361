// SPDX-License-Identifier: MIT
// Introduced by stage 09: how boxes are padded against rounding, in shares of a coordinate: as the host pads them.
#include "scene_types.h"

#define PADDING SLAB_PADDING
