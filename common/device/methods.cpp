// SPDX-License-Identifier: MIT
#include "device/methods.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/errors.h"

namespace stagelight {

const std::vector<Method> &all_methods() {
    static const std::vector<Method> methods = {
        {"interior", "full", "", "Snell, Schlick and Beer at every wall, to the depth limit"},
        {"interior", "paper", "METHOD_INTERIOR_PAPER",
         "the paper, section 5: once through the sphere, no reflection inside"},
    };
    return methods;
}

void choose_method(Methods &methods, const std::string &choice) {
    std::string known;
    for (const Method &method : all_methods()) {
        const std::string name = method.kind + '=' + method.name;
        if (name == choice) {
            methods[method.kind] = method.name;
            return;
        }
        known += (known.empty() ? "" : ", ") + name;
    }
    throw UserError(fmt::format("--method {}: expected one of {}", choice, known));
}

std::vector<std::string> defines_of(const Methods &methods) {
    std::vector<std::string> defines;
    for (const Method &method : all_methods()) {
        const auto chosen = methods.find(method.kind);
        if (chosen != methods.end() && chosen->second == method.name && !method.define.empty()) {
            defines.push_back(method.define);
        }
    }
    return defines;
}

}  // namespace stagelight
