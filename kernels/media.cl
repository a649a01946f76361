// SPDX-License-Identifier: MIT
// Introduced by stage 04: which of the dielectrics that hold a point is there.
#include "scene.cl"

// #region medium_at
// That of the highest bit (Schmidt and Budge, Simple Nested Dielectrics in Ray Traced Images, 2002): the host has
// put them in order. Where there is none, it is air.
static DielectricMaterial medium_at(const Scene *scene, const uint media) {
    DielectricMaterial medium = {.ior = 1.0f};
    if (HAS_MEDIA && media > 0) {
        medium = scene->materials[31 - clz(media)].as.dielectric;
    }
    return medium;
}
// #endregion medium_at

// #region media_beyond
static uint media_beyond(const uint media, const Surface *surface, const DielectricMaterial *glass) {
    return surface->from_behind ? media & ~glass->medium : media | glass->medium;
}

// Whether another is there on both sides of its surface.
static bool is_overruled(const DielectricMaterial *glass, const uint media) {
    return (media & ~glass->medium) > glass->medium;
}
// #endregion media_beyond
