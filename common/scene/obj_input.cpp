// SPDX-License-Identifier: MIT
#include "scene/obj_input.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace stagelight {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

// Calls `visit` with each line, without its end.
template <typename Visit> void for_each_line(std::string_view text, const Visit &visit) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        visit(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

std::string_view without_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Takes the first word off `rest`.
std::string_view next_word(std::string_view &rest) {
    rest = without_blanks(rest);
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(word.size());
    return word;
}

// Up to a comment.
std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    line = line.substr(0, line.find('#'));
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
        words.push_back(word);
    }
    return words;
}

std::optional<double> number_of(std::string_view word) {
    const std::string text(word);
    char *end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0' ? std::optional(value) : std::nullopt;
}

std::string lower_case(std::string_view word) {
    std::string lower(word);
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return lower;
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
    if (blanks.find(line[1]) != std::string_view::npos) {
        return line[0] == 'v' ? Line::position : Line::face;
    }
    const bool has_two_letters = line[0] == 'v' && blanks.find(line[2]) != std::string_view::npos;
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

// Counts words alone: most files are long, and right as they are.
std::size_t count_words(std::string_view line) {
    std::size_t count = 0;
    bool in_word = false;
    for (const char c : line) {
        if (c == '#') {
            break;
        }
        const bool is_blank = blanks.find(c) != std::string_view::npos;
        count += !is_blank && !in_word ? 1 : 0;
        in_word = !is_blank;
    }
    return count;
}

bool has_leading_point(std::string_view line) {
    for (std::size_t at = line.find('.'); at != std::string_view::npos;
         at = line.find('.', at + 1)) {
        if (blanks.find(line[at - 1]) != std::string_view::npos) {  // a key stands before it
            return true;
        }
    }
    return false;
}

// Whether the corners of a face have the same of their indices, and the file what they name.
bool is_even(const std::vector<Corner> &corners, std::size_t index, const Obj &obj) {
    return obj.counts[index] > 0 && std::ranges::all_of(corners, [&](const Corner &corner) {
               return !corner.indices[index].empty();
           });
}

std::vector<Corner> corners_of(std::string_view line) {
    std::vector<Corner> corners;
    for (const std::string_view word : words_of(line.substr(1))) {
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

bool is_right(std::string_view line, const Obj &obj) {
    const Line kind = kind_of(line);
    if (kind != Line::other && line.find('#') != std::string_view::npos) {
        return false;  // Assimp counts a comment's numbers
    }
    switch (kind) {
    case Line::position:
        return count_words(line) == (obj.has_colors ? with_color : 4) && !has_leading_point(line);
    case Line::coordinates: {
        const std::size_t words = count_words(line);
        return (words == 3 || words == 4) && !has_leading_point(line);
    }
    case Line::face:
        return false;
    default:
        return true;
    }
}

std::string right(std::string_view line, const Obj &obj) {
    const std::vector<std::string_view> words = words_of(line);
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

}  // namespace

namespace {

bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
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
        prepared += is_right(line, obj) ? std::string(line) : right(line, obj);
        prepared += '\n';
    });
    return prepared;
}

namespace {

// What a line `map_Kd [options] file` says.
struct Map {
    glm::dvec3 offset{0, 0, 0};
    glm::dvec3 scale{1, 1, 1};
    bool is_clamped = false;
    std::string_view file;
};

// -o and -s take one to three numbers.
void take_numbers(std::string_view &rest, glm::dvec3 &values) {
    for (int i = 0; i < 3; ++i) {
        std::string_view after = rest;
        const std::optional<double> value = number_of(next_word(after));
        if (!value || without_blanks(after).empty()) {  // a file may have a number for its name
            break;
        }
        values[i] = *value;
        rest = after;
    }
}

Map map_of(std::string_view rest) {
    Map map;
    for (;;) {
        std::string_view after = rest;
        const std::string option = lower_case(next_word(after));
        if (option.size() < 2 || option[0] != '-') {
            break;
        }
        rest = after;
        glm::dvec3 unused(0);
        if (option == "-o" || option == "-s" || option == "-t") {
            take_numbers(rest, option == "-o" ? map.offset : option == "-s" ? map.scale : unused);
        } else if (option == "-mm") {
            next_word(rest);
            next_word(rest);
        } else {
            const std::string_view value = next_word(rest);
            map.is_clamped = map.is_clamped || (option == "-clamp" && lower_case(value) == "on");
        }
    }
    map.file = without_blanks(rest);
    return map;
}

// v goes up in MTL, and down for us.
glm::dmat3 transform_of(const Map &map) {
    return {map.scale.x,
            0,
            0,  //
            0,
            map.scale.y,
            0,  //
            map.offset.x,
            1 - map.scale.y - map.offset.y,
            1};
}

struct Mtl {
    std::string text;
    std::optional<std::string> name;  // none before the first
    // Some programs write Tr for d: where there is a d, it is believed.
    std::optional<double> opacity, transparency;
    bool has_texture = false;  // of colours

    void end_material() {
        if (opacity || transparency) {
            text += fmt::format("d {}\n", opacity ? *opacity : 1 - *transparency);
        }
        opacity.reset();
        transparency.reset();
        has_texture = false;
    }
};

// Red alone stands for a grey.
std::string color_line(const std::vector<std::string_view> &words) {
    std::vector<double> values;
    for (std::size_t i = 1; i < words.size() && i <= 3; ++i) {
        if (const std::optional<double> value = number_of(words[i])) {
            values.push_back(*value);
        }
    }
    if (values.empty() || values.size() + 1 < std::min<std::size_t>(words.size(), 4)) {
        return "";  // spectral curves, and what is no colour at all
    }
    values.resize(3, values.back());
    return fmt::format("Kd {} {} {}\n", values[0], values[1], values[2]);
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 10> not_drawn{
    {{"map_bump", "a bump map"},
     {"bump", "a bump map"},
     {"map_kn", "a normal map"},
     {"norm", "a normal map"},
     {"disp", "a displacement map"},
     {"map_disp", "a displacement map"},
     {"map_ks", "a map of reflections"},
     {"refl", "a map of reflections"},
     {"map_ke", "a map of its own light"},
     {"map_emissive", "a map of its own light"}}};

}  // namespace

std::string prepared_mtl(std::string_view text, MeshNotes &notes) {
    Mtl mtl;
    for_each_line(text, [&](std::string_view line) {
        std::string_view rest = line;
        const std::string key = lower_case(next_word(rest));
        if (key == "newmtl") {
            mtl.end_material();
            mtl.name = without_blanks(rest);
            mtl.text += fmt::format("newmtl {}\n", *mtl.name);
        } else if (!mtl.name) {  // of no material
        } else if (key == "kd") {
            mtl.text += color_line(words_of(line));
        } else if (key == "d") {
            mtl.opacity = number_of(next_word(rest));  // none for `d -halo 0.5`
        } else if (key == "tr") {
            mtl.transparency = number_of(next_word(rest));
        } else if (key == "map_kd" || key == "map_d") {
            const Map map = map_of(rest);
            if (key == "map_kd" || !mtl.has_texture) {  // a mask alone is its own texture
                notes.materials[*mtl.name].texture_transform = transform_of(map);
            }
            mtl.has_texture = mtl.has_texture || key == "map_kd";
            mtl.text += fmt::format("{}{} {}\n", key == "map_d" ? "map_d" : "map_Kd",
                                    map.is_clamped ? " -clamp on" : "", map.file);
        } else if (const auto *found =
                       std::ranges::find(not_drawn, key, &decltype(not_drawn)::value_type::first);
                   found != not_drawn.end()) {
            notes.materials[*mtl.name].not_drawn.emplace(found->second);
        }
    });
    mtl.end_material();
    return mtl.text + "# Assimp refuses 15 bytes and less\n";
}

}  // namespace stagelight
