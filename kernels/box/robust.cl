// SPDX-License-Identifier: MIT
// Introduced by stage 09: how much room boxes leave for rounding, in shares of a coordinate. As the makers of
// the boxes leave it.
#include "scene_types.h"

#define ROOM SLAB_ROOM
