// SPDX-License-Identifier: MIT
// Tracers that draw the same picture, timed in turn.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/report.h"
#include "device/renderer.h"
#include "image/compare.h"
#include "image/image.h"
#include "reference/reference.h"

namespace stagelight::bench {

struct Drawn {
    Image image;
    std::uint64_t rays = 0;  // 0 where nobody counts them
    double milliseconds = 0;
};

struct Contestant {
    std::string name;
    std::function<Drawn()> draw;

    std::vector<double> milliseconds{};
    std::uint64_t rays = 0;
    Image image{};
    Comparison comparison{};  // with the reference in double
};

// The stage's own program.
Contestant ours(Renderer &renderer, const std::string &stage);

// How far a picture may be from the truth's.
struct Agreement {
    double inside = 1e-3;             // the share of the pixels inside surfaces more than 1/255 off
    double edges = 1e-3;              // and that of those on an edge, both of all pixels
    double mean_signed_error = 1e-4;  // as in Tolerance
};

// Each draws once, which is not timed: that picture must be the truth's, and its rays as many as
// the first one's but for one in a thousand. Prints a line for each that fails, and returns whether
// all are right.
bool agree(std::vector<Contestant> &contestants, const reference::Result &truth,
           const Agreement &agreement = {});

// Each draws in turn, `rounds` times.
void time_in_turn(std::vector<Contestant> &contestants, int rounds);

// The median over the rounds of how many times longer `other` took than `one`.
double ratio_of(const Contestant &other, const Contestant &one);

// A line for each: milliseconds, million rays/s, how many times as long as the first, and how
// many pixels are more than 1/255 off the truth.
std::string table_of(const std::vector<Contestant> &contestants);
ordered_json json_of(const std::vector<Contestant> &contestants);

}  // namespace stagelight::bench
