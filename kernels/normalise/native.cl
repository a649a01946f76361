// SPDX-License-Identifier: MIT
// The direction of a vector, as the device does it fastest: the error is the device's own.
#include "real.cl"

static float3 native_normalize(const float3 a) {
    return NATIVE_RSQRT(dot(a, a)) * a;
}
#define normalize native_normalize
