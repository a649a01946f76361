// SPDX-License-Identifier: MIT
// Lines and words of the text files that meshes come in.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace stagelight {

constexpr std::string_view blanks = " \t\r\v\f";

// Calls `visit` with each line, without its end.
template <typename Visit> void for_each_line(std::string_view text, const Visit &visit) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        visit(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

// Without those before and after it.
inline std::string_view without_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Takes the first word off `rest`.
inline std::string_view next_word(std::string_view &rest) {
    rest = without_blanks(rest);
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(word.size());
    return word;
}

inline std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
        words.push_back(word);
    }
    return words;
}

// Of ASCII's letters.
inline std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return lower;
}

}  // namespace stagelight
