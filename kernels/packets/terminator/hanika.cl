// SPDX-License-Identifier: MIT
// Introduced by stage 11: the light is Lambert's, as terminator/hanika.cl has it. Lifts are fetched lane by lane.
#include "packets/wide.cl"

static Wide wide_shadowing(const WideSurfaces *surfaces, const Wide3 direction, const Wide cosine) {
    return 1.0f;
}
