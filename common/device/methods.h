// SPDX-License-Identifier: MIT
// Choices that a tracer has, each with its methods: --method KIND=NAME.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace stagelight {

struct Method {
    std::string kind;
    std::string name;
    std::string define;  // what the kernels are built with; empty for the default
    std::string source;  // where it comes from
};

// All there are; of each kind the first is the default.
const std::vector<Method> &all_methods();

// What was chosen, by kind; a kind that is missing stands for its default.
using Methods = std::map<std::string, std::string>;

// Adds a choice "KIND=NAME". Throws UserError with the list of what there is.
void choose_method(Methods &methods, const std::string &choice);

// The names to define for the chosen methods.
std::vector<std::string> defines_of(const Methods &methods);

}  // namespace stagelight
