// SPDX-License-Identifier: MIT
// Without a smooth mesh, or with shadows that are the facets', nothing is lifted or faded. The host chooses this
// file then, and no kernel calls it.
#include "scene.cl"

static float3 lift_off_facet(const Scene *scene, const Surface *surface, const Hit hit) {
    return (float3)(0.0f);
}

static float shadowing(const Surface *surface, const float3 direction, const float cosine) {
    return 1.0f;
}
