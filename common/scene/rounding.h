// SPDX-License-Identifier: MIT
// What counts as the same place.
#pragma once

namespace stagelight {

// Half of the distance from 1 to the next float: how far rounding moves a number, of its size.
constexpr double float_rounding = 0x1p-24;

// Surfaces that are as close as this, of the size of their coordinates and of the distance they are
// seen from, can't be told apart by rays in float: a hit takes a dozen roundings.
constexpr double touching = 16 * float_rounding;

}  // namespace stagelight
