// SPDX-License-Identifier: MIT
#include "device/ray_totals.h"

#include <algorithm>

namespace stagelight {

RayTotals &RayTotals::operator+=(const RayTotals &more) {
    primary += more.primary;
    shadow += more.shadow;
    reflection += more.reflection;
    refraction += more.refraction;
    dropped += more.dropped;
    cut_off += more.cut_off;
    cut_off_weight = std::max(cut_off_weight, more.cut_off_weight);
    return *this;
}

RayTotals totals_of(const std::vector<device::RayCounts> &rows, std::size_t pixels) {
    RayTotals totals;
    totals.primary = pixels;
    for (const device::RayCounts &row : rows) {
        totals += {0,
                   row.shadow,
                   row.reflection,
                   row.refraction,
                   row.dropped,
                   row.cut_off,
                   static_cast<double>(row.cut_off_weight) / CUT_OFF_WEIGHT_ONE};
    }
    return totals;
}

}  // namespace stagelight
