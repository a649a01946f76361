// SPDX-License-Identifier: MIT
// Introduced by stage 09: the directions of vectors.
#include "wide.cl"

static Wide3 wide_unit(const Wide3 a) {
    return wide_scaled(1.0f / sqrt(wide_dot(a, a)), a);
}
