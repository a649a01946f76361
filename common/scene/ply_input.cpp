// SPDX-License-Identifier: MIT
#include "scene/ply_input.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace stagelight {

std::optional<std::string> prepared_ply(std::string_view bytes, MeshNotes &notes) {
    constexpr std::string_view end_of_header = "end_header";
    const std::size_t end = bytes.find(end_of_header);
    if (!bytes.starts_with("ply") || end == std::string_view::npos) {
        return std::nullopt;
    }
    std::istringstream lines{std::string(bytes.substr(0, end))};
    std::string header;
    bool has_strips = false, has_faces = false, in_strips = false, in_faces = false;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string keyword, first, second, third, fourth;
        words >> keyword >> first >> second >> third >> fourth;
        if (keyword == "element") {
            in_strips = first == "tristrips" || first == "tristrip";
            in_faces = first == "face" && second != "0";
            has_strips = has_strips || in_strips;
            has_faces = has_faces || in_faces;
            line = in_strips ? fmt::format("element face {}", second) : line;
        } else if (keyword == "property" && in_strips && first == "list") {
            line = fmt::format("property list {} {} vertex_indices", second, third);
        } else if (keyword == "property" && in_faces && second == "red") {
            notes.warnings.insert("has colours of faces, which aren't drawn");
        }
        header += line;
        header += '\n';
    }
    if (!has_strips) {
        return std::nullopt;
    }
    if (has_faces) {
        throw std::invalid_argument("has faces and triangle strips, expected one of them");
    }
    notes.has_strips = true;
    return header + std::string(bytes.substr(end));
}

void take_strips_apart(aiMesh &mesh) {
    constexpr auto end_of_strip = static_cast<unsigned>(-1);
    std::vector<std::array<unsigned, 3>> triangles;
    for (const aiFace &strip : std::span(mesh.mFaces, mesh.mNumFaces)) {
        std::size_t length = 0;
        for (unsigned i = 0; i < strip.mNumIndices; ++i) {
            length = strip.mIndices[i] == end_of_strip ? 0 : length + 1;
            if (length >= 3) {
                std::array corners{strip.mIndices[i - 2], strip.mIndices[i - 1], strip.mIndices[i]};
                if (length % 2 == 0) {  // every other one winds the other way round
                    std::swap(corners[0], corners[1]);
                }
                triangles.push_back(corners);
            }
        }
    }
    delete[] mesh.mFaces;
    mesh.mFaces = new aiFace[triangles.size()];
    mesh.mNumFaces = static_cast<unsigned>(triangles.size());
    mesh.mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        mesh.mFaces[i].mNumIndices = 3;
        mesh.mFaces[i].mIndices = new unsigned[3];
        std::ranges::copy(triangles[i], mesh.mFaces[i].mIndices);
    }
}

}  // namespace stagelight
