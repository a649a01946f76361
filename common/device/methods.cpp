// SPDX-License-Identifier: MIT
#include "device/methods.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/errors.h"
#include "scene/lessons.h"

namespace stagelight {
namespace {

const std::vector<Method> &all_methods() {
    static const std::vector<Method> methods = {
        {"interior", "full", 4, "", "Snell, Schlick and Beer at every wall, to the depth limit"},
        {"interior", "paper", 4, "METHOD_INTERIOR_PAPER",
         "the paper, section 5: once through the sphere, no reflection inside"},
        {"decode", "srgb", gamma_stage, "",
         "IEC 61966-2-1: texels are sRGB, as pictures mostly are"},
        {"decode", "2.2", gamma_stage, "", "the paper, section 8: texels are light to 1 / 2.2"},
        {"encode", "srgb", gamma_stage, "", "IEC 61966-2-1: the picture is for an sRGB screen"},
        {"encode", "2.2", gamma_stage, "", "the paper, section 8: light to 1 / 2.2"},
    };
    return methods;
}

std::string choice_of(const Method &method) {
    return method.kind + '=' + method.name;
}

std::string choices_of(int stage) {
    std::string choices;
    for (const Method &method : methods_of(stage)) {
        choices += (choices.empty() ? "" : ", ") + choice_of(method);
    }
    return choices.empty() ? fmt::format("none: {} has no methods", stage_name(stage))
                           : "one of " + choices;
}

Transfer transfer_of(const char *kind, int stage, const Methods &methods) {
    if (stage < gamma_stage) {
        return Transfer::none;
    }
    const auto chosen = methods.find(kind);
    return chosen != methods.end() && chosen->second == "2.2" ? Transfer::power : Transfer::srgb;
}

}  // namespace

std::vector<Method> methods_of(int stage) {
    std::vector<Method> methods = all_methods();
    std::erase_if(methods, [stage](const Method &method) { return method.first_stage > stage; });
    return methods;
}

void choose_method(Methods &methods, const std::string &choice, int stage) {
    const auto chosen = std::ranges::find(all_methods(), choice, choice_of);
    if (chosen == all_methods().end()) {
        throw UserError(fmt::format("--method {}: expected {}", choice, choices_of(stage)));
    }
    if (chosen->first_stage > stage) {
        throw UserError(fmt::format(
            "--method {}: {} has not learnt that yet; {} is the first stage that has it", choice,
            stage_name(stage), stage_name(chosen->first_stage)));
    }
    methods[chosen->kind] = chosen->name;
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

Transfer decode_of(int stage, const Methods &methods) {
    return transfer_of("decode", stage, methods);
}

Transfer encode_of(int stage, const Methods &methods) {
    return transfer_of("encode", stage, methods);
}

}  // namespace stagelight
