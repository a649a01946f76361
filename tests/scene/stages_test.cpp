// SPDX-License-Identifier: MIT
#include "scene/stages.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace stagelight {
namespace {

TEST(Stages, AreTheFoldersThatThereAre) {
    std::vector<std::string> folders;
    for (const auto &entry : std::filesystem::directory_iterator(
             std::filesystem::path(STAGELIGHT_SOURCE_DIR) / "stages")) {
        if (entry.is_directory()) {
            folders.push_back(entry.path().filename());
        }
    }
    std::ranges::sort(folders);
    EXPECT_EQ(stage_names(), folders);
}

TEST(Stages, AreNumberedFromOneOn) {
    for (int number = 1; number <= int(stage_names().size()); ++number) {
        EXPECT_TRUE(stage_name(number).starts_with(fmt::format("{:02}_", number)))
            << stage_name(number);
        EXPECT_EQ(stage_number(stage_name(number)), number);
    }
}

}  // namespace
}  // namespace stagelight
