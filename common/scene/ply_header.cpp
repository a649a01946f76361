// SPDX-License-Identifier: MIT
#include "scene/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scene/text.h"

namespace stagelight {
namespace {

struct Property {
    std::size_t list_size = 0;  // bytes of a list's length; 0 for a single value
    std::size_t size = 0;       // bytes of a value
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    enum class Format { text, little_endian, big_endian };
    Format format = Format::text;
    std::vector<Element> elements;
    bool is_known = true;  // each property's size
    bool has_end = false;
};

// Without its end, which is "\n", "\r" or both.
std::string_view take_line(std::string_view &bytes) {
    const std::size_t length = std::min(bytes.find_first_of("\r\n"), bytes.size());
    const std::string_view line = bytes.substr(0, length);
    bytes.remove_prefix(length);
    bytes.remove_prefix(bytes.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, bytes.size()));
    return line;
}

// In bytes; 0 for a type that PLY does not have.
std::size_t size_of(std::string_view type) {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 16> sizes{{{"char", 1},
                                                                              {"int8", 1},
                                                                              {"uchar", 1},
                                                                              {"uint8", 1},
                                                                              {"short", 2},
                                                                              {"int16", 2},
                                                                              {"ushort", 2},
                                                                              {"uint16", 2},
                                                                              {"int", 4},
                                                                              {"int32", 4},
                                                                              {"uint", 4},
                                                                              {"uint32", 4},
                                                                              {"float", 4},
                                                                              {"float32", 4},
                                                                              {"double", 8},
                                                                              {"float64", 8}}};
    const auto *const known =
        std::ranges::find(sizes, type, [](const auto &size) { return size.first; });
    return known == sizes.end() ? 0 : known->second;
}

Property property_of(const std::vector<std::string_view> &words) {
    if (words.size() > 3 && words[1] == "list") {
        // A length of no size would be a single value.
        return {.list_size = size_of(words[2]), .size = size_of(words[2]) ? size_of(words[3]) : 0};
    }
    return {.size = words.size() > 1 ? size_of(words[1]) : 0};
}

void add_line(Header &header, const std::vector<std::string_view> &words) {
    const std::string_view keyword = words.empty() ? "" : words[0];
    if (keyword == "format" && words.size() > 1) {
        header.format = words[1] == "binary_little_endian" ? Header::Format::little_endian
                        : words[1] == "binary_big_endian"  ? Header::Format::big_endian
                                                           : Header::Format::text;
    } else if (keyword == "element" && words.size() > 2) {
        Element element{.name = std::string(words[1]), .count = 0, .properties = {}};
        std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count);
        header.elements.push_back(std::move(element));
    } else if (keyword == "property" && !header.elements.empty()) {
        const Property property = property_of(words);
        header.is_known = header.is_known && property.size > 0;
        header.elements.back().properties.push_back(property);
    }
    header.has_end = keyword == "end_header";
}

Header take_header(std::string_view &bytes) {
    Header header;
    while (!bytes.empty() && !header.has_end) {
        add_line(header, words_of(take_line(bytes)));
    }
    return header;
}

std::uint64_t number(std::string_view bytes, bool is_big_endian) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const std::size_t place = is_big_endian ? i : bytes.size() - 1 - i;
        value = value << 8 | static_cast<unsigned char>(bytes[place]);
    }
    return value;
}

// The length of the row that starts `bytes`, or none if they end before it.
std::optional<std::uint64_t> row_length(const Element &element, std::string_view bytes,
                                        bool is_big_endian) {
    std::uint64_t length = 0;
    for (const Property &property : element.properties) {
        std::uint64_t values = 1;
        if (property.list_size > 0) {
            if (length + property.list_size > bytes.size()) {
                return std::nullopt;
            }
            values = number(bytes.substr(length, property.list_size), is_big_endian);
            length += property.list_size;
            if (values > bytes.size()) {
                return std::nullopt;
            }
        }
        length += values * property.size;
        if (length > bytes.size()) {
            return std::nullopt;
        }
    }
    return length;
}

// Removes the rows of an element from `bytes`; false if they end before.
bool skip_binary(const Element &element, std::string_view &bytes, bool is_big_endian) {
    for (std::uint64_t row = 0; row < element.count; ++row) {
        const auto length = row_length(element, bytes, is_big_endian);
        if (!length) {
            return false;
        }
        bytes.remove_prefix(*length);
    }
    return true;
}

// The same for text, where a value takes a digit and a space or the end of the line; the last
// line may have no end.
bool skip_text(const Element &element, std::string_view &bytes) {
    const std::size_t row = 2 * element.properties.size();
    if (element.count > (bytes.size() + 1) / row) {
        return false;
    }
    bytes.remove_prefix(std::min(element.count * row, bytes.size()));
    return true;
}

bool skip_rows(const Header &header, const Element &element, std::string_view &bytes) {
    if (element.properties.empty() || !header.is_known) {
        return element.count <= bytes.size() + 1;
    }
    return header.format == Header::Format::text
               ? skip_text(element, bytes)
               : skip_binary(element, bytes, header.format == Header::Format::big_endian);
}

}  // namespace

std::string ply_fault(const std::filesystem::path &file) {
    std::ifstream stream(file, std::ios::binary);
    std::string content(4, '\0');
    stream.read(content.data(), 4);
    if (content != "ply\n" && content != "ply\r") {
        return "";
    }
    content.append(std::istreambuf_iterator<char>(stream), {});
    std::string_view bytes = content;
    const Header header = take_header(bytes);
    if (!header.has_end) {
        return "its header has no end, expected a line 'end_header'";
    }
    for (const Element &element : header.elements) {
        if (!skip_rows(header, element, bytes)) {
            return fmt::format("its header promises {} of '{}', expected as many as its {} bytes "
                               "hold",
                               element.count, element.name, content.size());
        }
    }
    return "";
}

}  // namespace stagelight
