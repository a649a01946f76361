// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "scene/errors.h"
#include "scene/temporary_folder.h"

namespace stagelight {

using Path = std::filesystem::path;

inline std::string read_bytes(const Path &file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void write_bytes(const Path &file, const std::string &bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

// A folder of its own for each test, gone afterwards.
class InFolder : public testing::Test {
protected:
    std::ptrdiff_t files() const {
        return std::distance(std::filesystem::directory_iterator(folder), {});
    }

private:
    TemporaryFolder temporary_;

protected:
    const Path folder = temporary_.path();
};

// The message of the UserError that `call` must throw: one line that holds `expected`.
template <typename Call> void expect_user_error(Call call, const std::string &expected) {
    try {
        call();
        ADD_FAILURE() << "expected a UserError with: " << expected;
    } catch (const UserError &error) {
        const std::string message = error.what();
        EXPECT_NE(message.find(expected), std::string::npos)
            << "expected: " << expected << "\nthe message: " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << "not one line: " << message;
    }
}

}  // namespace stagelight
