// SPDX-License-Identifier: MIT
// Beer's law, as the device does it fastest: the error is the device's own.
#include "ray.cl"

static float3 transmittance(const float3 absorption, const float distance) {
    return NATIVE_EXP(-absorption * distance);
}
