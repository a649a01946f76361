// SPDX-License-Identifier: MIT
// A display without a screen, for as long as a test needs one.
#pragma once

#include <string>

#include <sys/types.h>

namespace stagelight {

class Xvfb {
public:
    // Starts Xvfb with one screen of 1280x1024 pixels of `depth` bits, on a free display, and
    // sets DISPLAY of this process to it. Throws std::runtime_error when it does not start.
    explicit Xvfb(int depth = 24);
    ~Xvfb();
    Xvfb(const Xvfb &) = delete;
    Xvfb &operator=(const Xvfb &) = delete;

    const std::string &display() const { return display_; }  // ":99"

private:
    pid_t process_ = -1;
    std::string display_;
};

}  // namespace stagelight
