// SPDX-License-Identifier: MIT
#include "scene/obj_input.h"

#include <algorithm>
#include <array>
#include <vector>

#include "scene/text.h"

namespace stagelight {
namespace {

bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

// Up to a comment.
std::vector<std::string_view> words_of_line(std::string_view line) {
    return words_of(line.substr(0, line.find('#')));
}

// As many words as there are to be, none of which starts with a point.
std::string numbers(const std::vector<std::string_view> &words, std::size_t count) {
    std::string line(words.front());
    for (std::size_t i = 1; i <= count; ++i) {
        const std::string_view word = i < words.size() ? words[i] : "0";
        line += word.front() == '.' ? " 0" : " ";
        line += word;
    }
    return line;
}

enum class Line { position, coordinates, normal, face, other };

Line kind_of(std::string_view line) {
    if (line.size() < 3 || (line[0] != 'v' && line[0] != 'f')) {
        return Line::other;
    }
    const std::size_t last = line.find_last_not_of(blanks);
    if (last != std::string_view::npos && line[last] == '\\') {
        return Line::other;  // Assimp puts such lines together
    }
    if (is_blank(line[1])) {
        return line[0] == 'v' ? Line::position : Line::face;
    }
    const bool has_two_letters = line[0] == 'v' && is_blank(line[2]);
    return has_two_letters && line[1] == 't'   ? Line::coordinates
           : has_two_letters && line[1] == 'n' ? Line::normal
                                               : Line::other;
}

// Which of a corner's indices are there: a/b/c, a/b, a//c or a.
struct Corner {
    explicit Corner(std::string_view word) {
        for (std::size_t i = 0; i < 3 && !word.empty(); ++i) {
            const std::size_t slash = std::min(word.find('/'), word.size());
            indices[i] = word.substr(0, slash);
            word.remove_prefix(std::min(slash + 1, word.size()));
        }
    }
    std::array<std::string_view, 3> indices;  // of the position, coordinates and normal
};

struct Obj {
    std::array<std::size_t, 3> counts{};  // of positions, coordinates and normals
    bool has_colors = false;
};

constexpr std::size_t with_color = 7;  // words of `v x y z r g b`, at least

// Whether the corners of a face have the same of their indices, and the file what they name.
bool is_even(const std::vector<Corner> &corners, std::size_t index, const Obj &obj) {
    return obj.counts[index] > 0 && std::ranges::all_of(corners, [&](const Corner &corner) {
               return !corner.indices[index].empty();
           });
}

std::vector<Corner> corners_of(std::string_view line) {
    std::vector<Corner> corners;
    for (const std::string_view word : words_of_line(line.substr(1))) {
        corners.emplace_back(word);
    }
    return corners;
}

std::string face(std::string_view line, const Obj &obj) {
    const std::vector<Corner> corners = corners_of(line);
    const bool has_coordinates = is_even(corners, 1, obj), has_normals = is_even(corners, 2, obj);
    std::string text = "f";
    for (const Corner &corner : corners) {
        text += ' ';
        text += corner.indices[0];
        if (has_coordinates || has_normals) {
            text += '/';
        }
        if (has_coordinates) {
            text += corner.indices[1];
        }
        if (has_normals) {
            text += '/';
            text += corner.indices[2];
        }
    }
    return text;
}

std::string right(std::string_view line, const Obj &obj) {
    const std::vector<std::string_view> words = words_of_line(line);
    switch (kind_of(line)) {
    case Line::position:
        return numbers(words, 3)
               + (!obj.has_colors             ? ""
                  : words.size() < with_color ? " 1 1 1"
                                              : numbers({"", words[4], words[5], words[6]}, 3));
    case Line::coordinates:
        return numbers(words, words.size() > 3 ? 3 : 2);
    case Line::normal:
        return numbers(words, 3);
    default:
        return face(line, obj);
    }
}

// What one look at each byte tells of a file: most are long, and right as they are.
class ObjScan {
public:
    explicit ObjScan(std::string_view text) {
        for_each_line(text, [&](std::string_view line) {
            if (!line.empty() && is_blank(line[0])) {
                is_odd_ = true;  // Assimp takes no notice of such a line
                line = without_blanks(line);
            }
            switch (kind_of(line)) {
            case Line::position:
                scan_position(line);
                break;
            case Line::coordinates:
                ++obj.counts[1];
                scan_numbers(line, 3, 4);
                break;
            case Line::normal:
                ++obj.counts[2];
                break;
            case Line::face:
                scan_face(line);
                break;
            case Line::other:
                break;
            }
        });
        obj.has_colors = colored_ > 0;
        is_right = !is_odd_ && (colored_ == 0 || colored_ == obj.counts[0])
                   && !(uses_[1] && obj.counts[1] == 0) && !(uses_[2] && obj.counts[2] == 0);
    }

    Obj obj;
    bool is_right = false;

private:
    std::size_t scan_numbers(std::string_view line, std::size_t least, std::size_t most) {
        std::size_t words = 0;
        bool was_blank = true;
        for (const char c : line) {
            const bool blank = is_blank(c);
            words += was_blank && !blank ? 1 : 0;
            is_odd_ = is_odd_ || c == '#' || (was_blank && c == '.');
            was_blank = blank;
        }
        is_odd_ = is_odd_ || words < least || words > most;
        return words;
    }

    void scan_position(std::string_view line) {
        const std::size_t words = scan_numbers(line, 4, with_color);
        ++obj.counts[0];
        colored_ += words >= with_color ? 1 : 0;
        is_odd_ = is_odd_ || (words > 4 && words < with_color);
    }

    void scan_face(std::string_view line) {
        std::array<bool, 3> has{};  // an index of the position, coordinates, normal
        std::size_t at = 0;
        int first_form = -1;
        const auto end_word = [&] {
            if (has[0]) {
                const int form = (has[1] ? 1 : 0) + (has[2] ? 2 : 0);
                is_odd_ = is_odd_ || (first_form >= 0 && form != first_form);
                first_form = form;
                uses_[1] = uses_[1] || has[1];
                uses_[2] = uses_[2] || has[2];
            }
            has = {};
            at = 0;
        };
        for (const char c : line.substr(1)) {
            if (is_blank(c)) {
                end_word();
            } else if (c == '/') {
                at = std::min<std::size_t>(at + 1, 2);
            } else {
                is_odd_ = is_odd_ || c == '#';
                has[at] = true;
            }
        }
        end_word();
    }

    std::size_t colored_ = 0;
    bool is_odd_ = false;
    std::array<bool, 3> uses_{};
};

}  // namespace

std::optional<std::string> prepared_obj(std::string_view text, MeshNotes &notes) {
    const ObjScan scan(text);
    const Obj &obj = scan.obj;
    notes.vertices_in_file = obj.counts[0];
    if (scan.is_right) {
        return std::nullopt;
    }
    std::string prepared;
    for_each_line(text, [&](std::string_view line) {
        line = without_blanks(line);
        prepared += kind_of(line) == Line::other ? std::string(line) : right(line, obj);
        prepared += '\n';
    });
    return prepared;
}

}  // namespace stagelight
