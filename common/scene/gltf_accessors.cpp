// SPDX-License-Identifier: MIT
#include "scene/gltf_accessors.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace stagelight {
namespace {

using nlohmann::json;

enum ComponentType : int {
    signed_byte = 5120,
    unsigned_byte = 5121,
    signed_short = 5122,
    unsigned_short = 5123,
    unsigned_int = 5125,
    float_type = 5126,
};

std::size_t size_of(int component_type) {
    switch (component_type) {
    case signed_byte:
    case unsigned_byte:
        return 1;
    case signed_short:
    case unsigned_short:
        return 2;
    case unsigned_int:
    case float_type:
        return 4;
    default:
        throw std::out_of_range("a component type that glTF has not");
    }
}

std::size_t components_of(const std::string &type) {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 7> types{{{"SCALAR", 1},
                                                                             {"VEC2", 2},
                                                                             {"VEC3", 3},
                                                                             {"VEC4", 4},
                                                                             {"MAT2", 4},
                                                                             {"MAT3", 9},
                                                                             {"MAT4", 16}}};
    const auto *const found =
        std::ranges::find(types, type, &std::pair<std::string_view, std::size_t>::first);
    if (found == types.end()) {
        throw std::out_of_range("a type that glTF has not");
    }
    return found->second;
}

template <typename T> T read_as(const char *bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

// glTF is little-endian, as are all machines that run this.
float number_at(const char *bytes, int component_type, bool is_normalized) {
    const auto scaled = [&](float value, float largest) {
        return is_normalized ? std::max(value / largest, -1.0F) : value;
    };
    switch (component_type) {
    case signed_byte:
        return scaled(read_as<std::int8_t>(bytes), 127);
    case unsigned_byte:
        return scaled(read_as<std::uint8_t>(bytes), 255);
    case signed_short:
        return scaled(read_as<std::int16_t>(bytes), 32767);
    case unsigned_short:
        return scaled(read_as<std::uint16_t>(bytes), 65535);
    case unsigned_int:
        return static_cast<float>(read_as<std::uint32_t>(bytes));
    default:
        return read_as<float>(bytes);
    }
}

// RFC 4648, section 4.
std::string from_base64(std::string_view text) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit != std::string_view::npos) {
            bits = bits << 6U | static_cast<std::uint32_t>(digit);
            count += 6;
            if (count >= 8) {
                count -= 8;
                bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
            }
        }
    }
    return bytes;
}

// What RFC 3986 makes of %20.
std::string percent_decoded(std::string_view text) {
    std::string decoded;
    while (!text.empty()) {
        std::size_t taken = 1;
        char c = text[0];
        if (c == '%' && text.size() > 2) {
            const std::string digits(text.substr(1, 2));
            char *end = nullptr;
            const long value = std::strtol(digits.c_str(), &end, 16);
            if (*end == '\0') {
                c = static_cast<char>(value);
                taken = 3;
            }
        }
        decoded += c;
        text.remove_prefix(taken);
    }
    return decoded;
}

}  // namespace

std::string_view GltfAccessors::buffer(std::size_t index) {
    const json &buffer = document_.at("buffers").at(index);
    if (!buffer.contains("uri")) {
        return binary_;
    }
    const auto known = buffers_.find(index);
    if (known != buffers_.end()) {
        return known->second;
    }
    const std::string uri = buffer.at("uri");
    std::string bytes;
    if (uri.starts_with("data:")) {
        bytes = from_base64(std::string_view(uri).substr(std::min(uri.find(',') + 1, uri.size())));
    } else {
        bytes = read_beside_(uri);
        bytes = bytes.empty() ? read_beside_(percent_decoded(uri)) : bytes;
    }
    return buffers_.emplace(index, std::move(bytes)).first->second;
}

// From the first of `count` elements of this size on; `stride` becomes the way to the next.
std::string_view GltfAccessors::view(const json &from, std::size_t count, std::size_t element,
                                     std::size_t &stride) {
    const json &view = document_.at("bufferViews").at(from.at("bufferView").get<std::size_t>());
    const std::string_view all = buffer(view.at("buffer").get<std::size_t>());
    const std::size_t start = view.value("byteOffset", std::size_t{0});
    const std::size_t offset = from.value("byteOffset", std::size_t{0});
    const auto length = view.at("byteLength").get<std::size_t>();
    stride = std::max(view.value("byteStride", std::size_t{0}), element);
    if (start > all.size() || length > all.size() - start || offset > length
        || (count > 0
            && (element > length - offset || (count - 1) > (length - offset - element) / stride))) {
        throw std::out_of_range("an accessor ends past its buffer");
    }
    return all.substr(start + offset, length - offset);
}

std::vector<float> GltfAccessors::floats(std::size_t accessor) {
    const json &from = document_.at("accessors").at(accessor);
    const auto count = from.at("count").get<std::size_t>();
    const int type = from.at("componentType");
    const std::size_t components = components_of(from.at("type"));
    const bool is_normalized = from.value("normalized", false);
    const std::size_t size = size_of(type);
    const std::size_t element = size * components;
    std::vector<float> values;
    const auto put = [&](const char *bytes, float *to) {
        for (std::size_t i = 0; i < components; ++i) {
            to[i] = number_at(bytes + i * size, type, is_normalized);
        }
    };
    std::size_t stride = 0;
    if (from.contains("bufferView")) {
        const std::string_view bytes = view(from, count, element, stride);
        values.resize(count * components);
        for (std::size_t i = 0; i < count; ++i) {
            put(bytes.data() + i * stride, &values[i * components]);
        }
    }
    if (from.contains("sparse")) {
        const json &sparse = from.at("sparse");
        const auto changed = sparse.at("count").get<std::size_t>();
        const int index_type = sparse.at("indices").at("componentType");
        std::size_t index_stride = 0;
        const std::string_view indices =
            view(sparse.at("indices"), changed, size_of(index_type), index_stride);
        const std::string_view bytes = view(sparse.at("values"), changed, element, stride);
        if (count > std::size_t{1} << 28U) {  // zeros, that no byte of the file stands for
            throw std::out_of_range("a sparse accessor of more than memory holds");
        }
        values.resize(count * components);
        for (std::size_t i = 0; i < changed; ++i) {
            const auto at = static_cast<std::size_t>(
                number_at(indices.data() + i * index_stride, index_type, false));
            if (at >= count) {
                throw std::out_of_range("a sparse accessor's index");
            }
            put(bytes.data() + i * stride, &values[at * components]);
        }
    }
    return values;
}

// The accessor.
json GltfAccessors::append(const std::vector<float> &values, std::size_t count,
                           const std::string &type) {
    json &views = document_["bufferViews"];
    views.push_back({{"buffer", document_.at("buffers").size()},
                     {"byteOffset", converted_.size()},
                     {"byteLength", values.size() * sizeof(float)}});
    converted_.append(reinterpret_cast<const char *>(values.data()), values.size() * sizeof(float));
    return {{"bufferView", views.size() - 1},
            {"componentType", static_cast<int>(float_type)},
            {"count", count},
            {"type", type}};
}

void GltfAccessors::make_float(std::size_t accessor) {
    json &from = document_.at("accessors").at(accessor);
    if (from.at("componentType") != float_type) {
        const std::vector<float> values = floats(accessor);
        from = append(values, from.at("count"), from.at("type"));
    }
}

std::size_t GltfAccessors::add(const std::vector<float> &values, const std::string &type) {
    document_["accessors"].push_back(append(values, values.size() / components_of(type), type));
    return document_["accessors"].size() - 1;
}

std::string GltfAccessors::finish() {
    if (!converted_.empty()) {
        document_["buffers"].push_back(
            {{"uri", std::string(converted_buffer)}, {"byteLength", converted_.size()}});
    }
    return std::move(converted_);
}

}  // namespace stagelight
