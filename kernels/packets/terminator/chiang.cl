// SPDX-License-Identifier: MIT
// As terminator/chiang.cl.
#include "packets/wide.cl"

static Wide wide_shadowing(const WideSurfaces *surfaces, const Wide3 direction, const Wide cosine) {
    const Wide facing = MAX(wide_dot(surfaces->geometric_normal, direction), (Wide)(0.0f));
    const Wide unshadowed = cosine * wide_dot(surfaces->geometric_normal, surfaces->normal);
    const Wide g = facing < unshadowed ? facing / unshadowed : (Wide)(1.0f);
    return g + g * g - g * g * g;
}
