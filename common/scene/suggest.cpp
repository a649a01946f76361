// SPDX-License-Identifier: MIT
#include "scene/suggest.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace stagelight {
namespace {

// V. Levenshtein, Binary codes capable of correcting deletions, insertions, and
// reversals, 1966; row by row as by R. Wagner and M. Fischer, The string-to-string
// correction problem, 1974.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

// A slip changes a third of a name at most: more would be another word.
bool is_near(std::string_view wrong, std::string_view name) {
    return wrong.size() <= 2 * name.size()  // keeps a file-sized name cheap
           && edit_distance(wrong, name) <= (name.size() + 1) / 3;
}

}  // namespace

std::string suggest(std::string_view wrong, const std::vector<std::string_view> &known) {
    std::vector<std::string_view> near;
    std::copy_if(known.begin(), known.end(), std::back_inserter(near),
                 [&](std::string_view name) { return is_near(wrong, name); });
    if (near.empty()) {
        return fmt::format("expected one of {}", fmt::join(known, ", "));
    }
    return fmt::format("did you mean '{}'?",
                       *std::min_element(near.begin(), near.end(), [&](auto a, auto b) {
                           return edit_distance(wrong, a) < edit_distance(wrong, b);
                       }));
}

}  // namespace stagelight
