// SPDX-License-Identifier: MIT
// A child process at a terminal of its own.
#pragma once

#include <functional>
#include <string>

#include <sys/types.h>

namespace stagelight {

class AtTerminal {
public:
    // Runs `body` in a child, which ends with it. Throws std::runtime_error when there is no
    // terminal to be had.
    explicit AtTerminal(const std::function<void()> &body);
    ~AtTerminal();  // kills the child
    AtTerminal(const AtTerminal &) = delete;
    AtTerminal &operator=(const AtTerminal &) = delete;

    // Reads until `part` has come, the child has ended, or half a minute has passed.
    void wait_for(const std::string &part);
    // Types a line.
    void enter() const;
    // All that has come so far, lines ending in \r\n.
    const std::string &output() const { return output_; }

private:
    pid_t child_ = -1;
    int terminal_ = -1;
    std::string output_;
};

}  // namespace stagelight
