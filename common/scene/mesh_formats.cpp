// SPDX-License-Identifier: MIT
#include "scene/mesh_formats.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "scene/assimp_io.h"

namespace stagelight {
namespace {

struct Format {
    std::string_view extension, advice;
};

// Formats of other programs and scenes, which Assimp has no reader for, or half of one.
constexpr std::string_view from_usd =
    "a mesh that Assimp reads: this is USD, which Blender turns into glTF (.glb)";
constexpr std::string_view from_cad =
    "a mesh that Assimp reads: this has curved surfaces, which FreeCAD turns into glTF (.glb)";
constexpr std::string_view from_3mf =
    "a 3MF file without components and parts in files of their own (production extension), which "
    "Assimp's reader fails on: slicers and Blender turn it into STL, OBJ or glTF (.glb)";
constexpr std::string_view from_ogex = "another format than OpenGEX, which Assimp's reader fails "
                                       "on: Blender turns it into glTF (.glb)";
constexpr std::string_view from_project =
    "a mesh that Assimp reads: this is a program's own file, which that exports as glTF (.glb)";

constexpr std::array<Format, 17> formats{{{"usd", from_usd},
                                          {"usda", from_usd},
                                          {"usdc", from_usd},
                                          {"usdz", from_usd},
                                          {"3mf", from_3mf},
                                          {"ogex", from_ogex},
                                          {"step", from_cad},
                                          {"stp", from_cad},
                                          {"iges", from_cad},
                                          {"igs", from_cad},
                                          {"3dm", from_cad},
                                          {"max", from_project},
                                          {"ma", from_project},
                                          {"mb", from_project},
                                          {"c4d", from_project},
                                          {"skp", from_project},
                                          {"abc", from_project}}};

}  // namespace

std::optional<std::string> expected_instead_of(const std::filesystem::path &file) {
    std::array<char, 2> start{};
    std::ifstream(file, std::ios::binary).read(start.data(), start.size());
    if (start == std::array{'\xff', '\xfe'} || start == std::array{'\xfe', '\xff'}) {
        return "text in UTF-8: this is UTF-16, which iconv -f UTF-16 -t UTF-8 turns into it";
    }
    const auto *const found = std::ranges::find(formats, file_extension(file), &Format::extension);
    return found == formats.end() ? std::nullopt : std::optional<std::string>(found->advice);
}

}  // namespace stagelight
