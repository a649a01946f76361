// SPDX-License-Identifier: MIT
// Where the time goes between a program's start and its first picture.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "device/stage_kernel.h"
#include "scene/clock.h"

namespace stagelight {

// Parts that follow each other, so that their sum is the whole way.
class Startup {
public:
    // At the beginning of main. What came before it is of the first part.
    Startup();

    // All since the last part ended, up to `until` (now_milliseconds), was spent on this one.
    void done(const std::string &part, double until = now_milliseconds());
    // On making that kernel: on "tree", "kernel" and "upload", the rest on "device".
    void built(const StageKernel &kernel);
    // On what is no part of the way.
    void skip() { part_began_ = now_milliseconds(); }

    // In order, milliseconds.
    const std::vector<std::pair<std::string, double>> &parts() const { return parts_; }
    double total() const;

private:
    void add(const std::string &part, double milliseconds);

    double part_began_;
    std::vector<std::pair<std::string, double>> parts_;
};

}  // namespace stagelight
