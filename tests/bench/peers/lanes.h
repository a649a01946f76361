// SPDX-License-Identifier: MIT
// Arithmetic on one ray or on sixteen, with GCC's vectors: the same source for both of Embree's
// ways.
#pragma once

#include <cmath>

namespace stagelight::bench {

constexpr int packet_size = 16;

using Float16 = float __attribute__((vector_size(packet_size * sizeof(float))));
using Int16 = int __attribute__((vector_size(packet_size * sizeof(int))));

template <typename Number> struct Vec { Number x, y, z; };

template <typename N> Vec<N> operator+(const Vec<N> &a, const Vec<N> &b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename N> Vec<N> operator-(const Vec<N> &a, const Vec<N> &b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename N> Vec<N> operator*(const N &s, const Vec<N> &v) {
    return {s * v.x, s * v.y, s * v.z};
}
template <typename N> N dot(const Vec<N> &a, const Vec<N> &b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline float square_root(float v) {
    return std::sqrt(v);
}
inline Float16 square_root(Float16 v) {
    for (int i = 0; i < packet_size; ++i) {  // one instruction, with -fno-math-errno
        v[i] = std::sqrt(v[i]);
    }
    return v;
}

template <typename N> Vec<N> normalize(const Vec<N> &v) {
    return (1.0F / square_root(dot(v, v))) * v;
}

// `v` in every lane.
template <typename N> Vec<N> all_lanes(const Vec<float> &v) {
    return {N{} + v.x, N{} + v.y, N{} + v.z};
}

}  // namespace stagelight::bench
