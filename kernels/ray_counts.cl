// SPDX-License-Identifier: MIT
// Introduced by stage 02; extended by 11 (importance cutoff): counting rays, to know what a picture costs.
#include "scene_types.h"

// #region ray_counts
// Adds one work-item's counts to those of its row, which its neighbours add to as well.
static void add_ray_counts(__global RayCounts *row, const RayCounts counts) {
    // #region shadow_count
    if (counts.shadow > 0) {
        atomic_add(&row->shadow, counts.shadow);
    }
    // #endregion shadow_count
    if (counts.reflection > 0) {
        atomic_add(&row->reflection, counts.reflection);
    }
    if (counts.refraction > 0) {
        atomic_add(&row->refraction, counts.refraction);
    }
    if (counts.dropped > 0) {
        atomic_add(&row->dropped, counts.dropped);
    }
    if (CUTOFF_ONE_IN > 0 && counts.cut_off > 0) {
        atomic_add(&row->cut_off, counts.cut_off);
        atomic_max(&row->cut_off_weight, counts.cut_off_weight);
    }
}
// #endregion ray_counts
