// SPDX-License-Identifier: MIT
// The numbers in a glTF file's buffers.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/gltf_input.h"

namespace stagelight {

// Throws std::out_of_range for what points past the end, and nlohmann's exceptions for a document
// of another shape.
class GltfAccessors {
public:
    // `binary` is the buffer that a .glb holds; "" for none.
    GltfAccessors(nlohmann::json &document, std::string_view binary, ReadBeside read_beside)
        : document_(document), binary_(binary), read_beside_(std::move(read_beside)) {}

    // All components of all elements, as the specification (glTF 2.0, section 3.6.2.2) makes
    // numbers of normalised integers.
    std::vector<float> floats(std::size_t accessor);

    // Turns an accessor of integers into one of floats.
    void make_float(std::size_t accessor);

    // The index of a new accessor with these values. `type` is glTF's: SCALAR, VEC3, MAT4.
    std::size_t add(const std::vector<float> &values, const std::string &type);

    // The bytes of the buffer that new accessors lie in, which then is in the document.
    std::string finish();

private:
    std::string_view buffer(std::size_t index);
    std::string_view view(const nlohmann::json &from, std::size_t count, std::size_t element,
                          std::size_t &stride);
    nlohmann::json append(const std::vector<float> &values, std::size_t count,
                          const std::string &type);

    nlohmann::json &document_;
    std::string_view binary_;
    ReadBeside read_beside_;
    std::map<std::size_t, std::string> buffers_;  // those that were read
    std::string converted_;
};

}  // namespace stagelight
