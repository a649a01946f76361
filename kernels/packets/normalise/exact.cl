// SPDX-License-Identifier: MIT
// Introduced by stage 10: the directions of vectors.
#include "packets/wide.cl"

static Wide3 wide_normalize(const Wide3 a) {
    return wide_scaled(1.0f / sqrt(wide_dot(a, a)), a);
}
