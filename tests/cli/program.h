// SPDX-License-Identifier: MIT
// The stages' programs, started as a user starts them, each test in a folder of its own.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/temporary_folder.h"

namespace stagelight::cli {

// Pictures that take no time.
constexpr auto small = "32x20";

// The exit codes, as scripts know them.
constexpr int users_mistake = 2, machines_lack = 3;

// How a program ended, and what it said.
struct Outcome {
    int code = -1;  // minus the signal that ended it
    std::string out, err;
};

std::ostream &operator<<(std::ostream &stream, const Outcome &outcome);

struct Start {
    std::vector<std::string> arguments;
    std::vector<std::string> environment{};  // "NAME=value", beside what it inherits
    unsigned long largest_file = std::numeric_limits<unsigned long>::max();  // bytes
};

class Cli : public testing::Test {
protected:
    // Runs build/<preset>/stages/`stage` in `folder`, with none of the variables that Stagelight
    // reads, and no display, but for those of `start`. Kills it after a minute.
    Outcome run(const std::string &stage, const Start &start) const;
    Outcome run(const std::string &stage, const std::vector<std::string> &arguments) const {
        return run(stage, Start{arguments});
    }
    // Files and folders below `folder`, sorted.
    std::vector<std::string> files() const;

    TemporaryFolder folder;
};

// It did what it was asked.
void expect_done(const Outcome &outcome);
// It ended with `code`, and its only word was one line on stderr that holds `text`.
void expect_one_line(const Outcome &outcome, int code, const std::string &text);
void expect_part(const std::string &text, const std::string &part);

}  // namespace stagelight::cli
