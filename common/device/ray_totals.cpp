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
    faded += more.faded;
    faded_weight = std::max(faded_weight, more.faded_weight);
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
                   row.faded,
                   static_cast<double>(row.faded_weight) / FADED_WEIGHT_ONE};
    }
    return totals;
}

}  // namespace stagelight
