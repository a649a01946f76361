// SPDX-License-Identifier: MIT
// What to say of a name that nobody knows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stagelight {

// "did you mean 'radius'?" when one of the known names is near the wrong one, else
// "expected one of center, radius".
std::string suggest(std::string_view wrong, const std::vector<std::string_view> &known);

}  // namespace stagelight
