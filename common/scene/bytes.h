// SPDX-License-Identifier: MIT
// Numbers in the bytes of a file. What lies past the end is 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace stagelight {

inline std::uint32_t byte_at(std::string_view bytes, std::size_t place) {
    return place < bytes.size() ? static_cast<unsigned char>(bytes[place]) : 0U;
}

// Of `count` bytes, at most four, the least significant first.
inline std::uint32_t little_endian(std::string_view bytes, std::size_t place, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = count; i-- > 0;) {
        value = value << 8 | byte_at(bytes, place + i);
    }
    return value;
}

// The most significant first.
inline std::uint32_t big_endian(std::string_view bytes, std::size_t place, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        value = value << 8 | byte_at(bytes, place + i);
    }
    return value;
}

// Overwrites `count` bytes, the least significant first.
inline void put_little_endian(std::string &bytes, std::size_t place, std::size_t count,
                              std::uint32_t value) {
    for (std::size_t i = 0; i < count; ++i, value >>= 8) {
        bytes[place + i] = static_cast<char>(value & 255);
    }
}

}  // namespace stagelight
