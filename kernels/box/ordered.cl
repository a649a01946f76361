// SPDX-License-Identifier: MIT
// How much room boxes leave for rounding: none.
#include "scene_types.h"

#define ROOM 0.0f
