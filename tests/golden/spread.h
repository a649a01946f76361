// SPDX-License-Identifier: MIT
// How far pictures of devices that are right lie apart: what golden/tolerances.toml has to allow,
// and what it need not.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace stagelight::golden {

// A bound of the file, and the most that any picture under it takes up.
struct Needed {
    std::string place;  // "04_interior.every"
    std::string key;    // "strays"
    double bound = 0;
    double needed = 0;
    std::string by;  // the picture: "04_interior, pocl, math=mad"
};

// More than five times what is needed: an error that large would pass. What no picture needs is not
// taken for nothing: half a pixel of a count, and of light what rounding a golden to half precision
// can do.
bool is_too_loose(const std::string &key, double bound, double needed);

// About twice what is needed.
double proposed_bound(const std::string &key, double needed);

// Of all bounds, in the order of the goldens: each scene by the default methods on both
// implementations, and on PoCL by other flags of the compiler and at other widths, held to the
// golden and to the reference. `progress` is called after each scene.
std::vector<Needed> measure_spread(const std::function<void()> &progress);

}  // namespace stagelight::golden
