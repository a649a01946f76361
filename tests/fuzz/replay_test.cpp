// SPDX-License-Identifier: MIT
// What the fuzzers have found, tried again.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "fuzz/inputs.h"

namespace stagelight::fuzz {
namespace {

TEST(Findings, AreAnswered) {
    const std::map<std::string, void (*)(std::string_view)> readers{
        {"scene", read_scene}, {"mesh", read_mesh}, {"texture", read_texture}};
    std::size_t count = 0;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(
             STAGELIGHT_SOURCE_DIR "/tests/fuzz/findings")) {
        if (entry.is_regular_file()) {
            SCOPED_TRACE(entry.path());
            std::ifstream in(entry.path(), std::ios::binary);
            const std::string bytes{std::istreambuf_iterator<char>(in), {}};
            const auto read = readers.at(entry.path().parent_path().filename());
            EXPECT_NO_THROW(read(bytes));
            ++count;
        }
    }
    EXPECT_GT(count, 0U);
}

}  // namespace
}  // namespace stagelight::fuzz
