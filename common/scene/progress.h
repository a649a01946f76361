// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "scene/clock.h"

namespace stagelight {

// Says on a terminal what takes longer than two seconds: a line on stderr, with a bar where the
// number of steps is known, that is gone when this ends. It prints nothing where stderr is no
// terminal, nor inside another Progress, which tells of the whole and not of each part. While there
// may be one, print by say(): it clears the line first.
class Progress {
public:
    explicit Progress(std::string what, std::size_t steps = 1);
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;

    // One more is done.
    void step() { ++done_; }

private:
    void keep_drawing(const std::stop_token &stop);
    std::string text() const;

    std::string what_;
    std::size_t steps_;
    double start_ = now_milliseconds();
    bool is_drawn_;  // if it takes long enough
    std::atomic<std::size_t> done_ = 0;
    std::condition_variable_any wake_;
    std::jthread drawing_;  // the last, for it uses all others
};

// Prints a line on stdout, at once, which the bar on the terminal makes way for.
void say(const std::string &line);
// The same on stderr, after "warning: ", unless warnings are silenced.
void warn(const std::string &line);
// The same for lines of which at most five are printed: the fifth of more counts the others.
void warn(const std::vector<std::string> &lines);
// From now on no warning is printed.
void silence_warnings();
// All that were given to warn(), also what it didn't print.
std::vector<std::string> all_warnings();

}  // namespace stagelight
