// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/temporary_folder.h"

namespace stagelight {

// A glTF file in the making: one triangle, at the corner of z = 0, that one node places.
class GltfWriter {
public:
    nlohmann::json document = {
        {"asset", {{"version", "2.0"}}},
        {"scene", 0},
        {"scenes", {{{"nodes", {0}}}}},
        {"nodes", {{{"mesh", 0}}}},
        {"meshes", {{{"primitives", {{{"attributes", nlohmann::json::object()}}}}}}},
        {"accessors", nlohmann::json::array()},
        {"bufferViews", nlohmann::json::array()},
        {"buffers", {{{"uri", "a.bin"}}}},
    };

    GltfWriter() { attribute("POSITION", std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3"); }

    nlohmann::json &primitive() { return document["meshes"][0]["primitives"][0]; }

    // The index of an accessor with these values.
    template <typename T>
    std::size_t accessor(const std::vector<T> &values, const std::string &type,
                         std::size_t components, bool is_normalized = false) {
        bytes_.resize((bytes_.size() + 3) / 4 * 4);
        document["bufferViews"].push_back({{"buffer", 0},
                                           {"byteOffset", bytes_.size()},
                                           {"byteLength", values.size() * sizeof(T)}});
        bytes_.append(reinterpret_cast<const char *>(values.data()), values.size() * sizeof(T));
        document["accessors"].push_back({{"bufferView", document["bufferViews"].size() - 1},
                                         {"componentType", type_of(T{})},
                                         {"count", values.size() / components},
                                         {"type", type},
                                         {"normalized", is_normalized}});
        return document["accessors"].size() - 1;
    }

    // Of the three vertices.
    template <typename T>
    void attribute(const std::string &name, const std::vector<T> &values, const std::string &type,
                   bool is_normalized = false) {
        primitive()["attributes"][name] = accessor(values, type, values.size() / 3, is_normalized);
    }

    std::filesystem::path write(const TemporaryFolder &folder) {
        document["buffers"][0]["byteLength"] = bytes_.size();
        folder.write("a.bin", bytes_);
        return folder.write("a.gltf", document.dump());
    }

    // The same in one file.
    std::filesystem::path write_glb(const TemporaryFolder &folder) {
        document["buffers"][0] = {{"byteLength", bytes_.size()}};
        std::string text = document.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string binary = bytes_;
        binary.resize((binary.size() + 3) / 4 * 4);
        const auto word = [](std::size_t value) {
            const auto number = static_cast<std::uint32_t>(value);
            return std::string(reinterpret_cast<const char *>(&number), sizeof number);
        };
        return folder.write("a.glb", "glTF" + word(2) + word(28 + text.size() + binary.size())
                                         + word(text.size()) + "JSON" + text + word(binary.size())
                                         + std::string("BIN\0", 4) + binary);
    }

private:
    static int type_of(std::int8_t) { return 5120; }
    static int type_of(std::uint8_t) { return 5121; }
    static int type_of(std::int16_t) { return 5122; }
    static int type_of(std::uint16_t) { return 5123; }
    static int type_of(float) { return 5126; }

    std::string bytes_;
};

}  // namespace stagelight
