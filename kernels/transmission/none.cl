// SPDX-License-Identifier: MIT
// Glass that absorbs nothing.
#include "ray.cl"

static float3 transmittance(const float3 absorption, const float distance) {
    return (float3)(1.0f);
}
