// SPDX-License-Identifier: MIT
// Tracers that draw the same picture, timed in turn.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/report.h"
#include "image/compare.h"
#include "image/image.h"
#include "reference/reference.h"

namespace stagelight::bench {

struct Drawn {
    Image image;
    std::uint64_t rays = 0;
    double milliseconds = 0;
};

struct Contestant {
    std::string name;
    std::function<Drawn()> draw;

    std::vector<double> milliseconds{};
    std::uint64_t rays = 0;
    Comparison comparison{};  // with the reference in double
};

// Each draws once, which is not timed: that picture must be the truth's but for one pixel in a
// thousand, and its rays as many as the first one's. Prints a line for each that fails, and returns
// whether all are right.
bool agree(std::vector<Contestant> &contestants, const reference::Result &truth);

// Each draws in turn, `rounds` times: what slows the machine down for a while slows all.
void time_in_turn(std::vector<Contestant> &contestants, int rounds);

// The median over the rounds of how many times longer `other` took than `one`.
double ratio_of(const Contestant &other, const Contestant &one);

// A line for each: milliseconds, million rays/s, how many times as long as the first, and how
// many pixels are more than 1/255 off the truth.
std::string table_of(const std::vector<Contestant> &contestants);
ordered_json json_of(const std::vector<Contestant> &contestants);

}  // namespace stagelight::bench
