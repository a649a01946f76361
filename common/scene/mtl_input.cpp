// SPDX-License-Identifier: MIT
#include "scene/mtl_input.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <glm/mat3x3.hpp>

#include "scene/text.h"

namespace stagelight {
namespace {

std::optional<double> number_of(std::string_view word) {
    const std::string text(word);
    char *end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0' ? std::optional(value) : std::nullopt;
}

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
            mtl.text += color_line(words_of(line.substr(0, line.find('#'))));
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
