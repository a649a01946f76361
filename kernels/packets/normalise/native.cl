// SPDX-License-Identifier: MIT
// The directions of vectors, as the device does it fastest: the error is the device's own.
#include "packets/wide.cl"

static Wide3 wide_normalize(const Wide3 a) {
    return wide_scaled(NATIVE_RSQRT(wide_dot(a, a)), a);
}
