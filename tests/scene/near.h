// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

namespace stagelight {

template <glm::length_t N>
testing::AssertionResult is_near(const glm::vec<N, double> &actual,
                                 const glm::vec<N, double> &expected) {
    if (glm::length(actual - expected) < 1e-6) {
        return testing::AssertionSuccess();
    }
    testing::AssertionResult failure = testing::AssertionFailure();
    for (glm::length_t i = 0; i < N; ++i) {
        failure << fmt::format("[{}] expected {}, got {}; ", i, expected[i], actual[i]);
    }
    return failure;
}

}  // namespace stagelight
