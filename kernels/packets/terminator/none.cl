// SPDX-License-Identifier: MIT
// As terminator/none.cl.
#include "packets/wide.cl"

static Wide wide_shadowing(const WideSurfaces *surfaces, const Wide3 direction, const Wide cosine) {
    return 1.0f;
}
