// SPDX-License-Identifier: MIT
// Light fades out before the facet turns away from it. Made for bent normals: what the facets of a coarse mesh
// shadow stays dark.
#include "scene.cl"

static float3 lift_off_facet(const Scene *scene, const Surface *surface, const Hit hit) {
    return (float3)(0.0f);
}

// The share of Lambert's `cosine` that counts: the shadowing function G and its smooth form, which ends without a
// kink (Chiang, Li and Burley, Taming the Shadow Terminator, SIGGRAPH 2019 Talks, article 71).
static float shadowing(const Surface *surface, const float3 direction, const float cosine) {
    const float facing = MAX(dot(surface->geometric_normal, direction), 0.0f);
    const float unshadowed = cosine * dot(surface->geometric_normal, surface->normal);
    const float g = facing < unshadowed ? facing / unshadowed : 1.0f;
    return g + g * g - g * g * g;
}
