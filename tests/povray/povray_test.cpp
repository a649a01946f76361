// SPDX-License-Identifier: MIT
// Every stage's scenes, drawn by POV-Ray and held to the reference.
#include <iostream>

#include <gtest/gtest.h>

#include "povray/judge.h"
#include "scene/temporary_folder.h"

namespace stagelight::povray {
namespace {

class PovRay : public testing::TestWithParam<JudgedScene> {};

TEST_P(PovRay, DrawsWhatTheReferenceDraws) {
    const TemporaryFolder folder;
    const Comparison comparison = judge(GetParam(), folder.path()).comparison;
    EXPECT_EQ(comparison.failure, "");
    std::cout << to_string(comparison) << '\n';
}

INSTANTIATE_TEST_SUITE_P(Scenes, PovRay, testing::ValuesIn(judged_scenes()),
                         [](const auto &instance) { return "Stage" + instance.param.name; });

}  // namespace
}  // namespace stagelight::povray
