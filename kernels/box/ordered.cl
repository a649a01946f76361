// SPDX-License-Identifier: MIT
// How boxes are padded against rounding: not at all.
#include "scene_types.h"

#define PADDING 0.0f
