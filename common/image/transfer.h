// SPDX-License-Identifier: MIT
// Which curve lies between light and the values of a picture (kernels/transfer_curves.h has them).
#pragma once

namespace stagelight {

enum class Transfer {
    none,   // values are taken for light: stages before 08
    srgb,   // IEC 61966-2-1
    power,  // the paper's 2.2
    table,  // sRGB by a table, which only what is encoded goes through
};

// From light to the value in [0, 1] that a screen takes: not a number and negatives give 0, what is
// above 1 gives 1.
float encode(Transfer transfer, float light);

// From a value in [0, 1] to light.
float decode(Transfer transfer, float value);

}  // namespace stagelight
