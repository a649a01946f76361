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
        {"fresnel", "schlick", 10, "", "Schlick 1994, as the paper has it"},
        {"fresnel", "exact", 10, "METHOD_FRESNEL_EXACT",
         "Fresnel's equations, for light that is not polarised"},
        {"decode", "srgb", gamma_stage, "",
         "IEC 61966-2-1: texels are sRGB, as pictures mostly are"},
        {"decode", "2.2", gamma_stage, "", "the paper, section 8: texels are light to 1 / 2.2"},
        {"encode", "srgb", gamma_stage, "", "IEC 61966-2-1: the picture is for an sRGB screen"},
        {"encode", "2.2", gamma_stage, "", "the paper, section 8: light to 1 / 2.2"},
        {"width", "device", acceleration_stage, "",
         "rays side by side in a work-item: 1 on a GPU, else the width that the device prefers"},
        {"width", "1", acceleration_stage, "", "one ray in a work-item"},
        {"width", "4", acceleration_stage, "", "2x2 rays side by side"},
        {"width", "8", acceleration_stage, "", "4x2 rays side by side"},
        {"width", "16", acceleration_stage, "", "4x4 rays side by side"},
        {"nodes", "4", acceleration_stage, "", "four children to a node of the tree"},
        {"nodes", "2", acceleration_stage, "", "two children to a node of the tree"},
        {"nodes", "8", acceleration_stage, "", "eight children to a node of the tree"},
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
    return choice(methods, kind) == "2.2" ? Transfer::power : Transfer::srgb;
}

}  // namespace

std::vector<Method> methods_of(int stage) {
    std::vector<Method> methods = all_methods();
    std::erase_if(methods, [stage](const Method &method) { return method.first_stage > stage; });
    return methods;
}

std::string choice(const Methods &methods, const std::string &kind) {
    const auto chosen = methods.find(kind);
    return chosen != methods.end() ? chosen->second
                                   : std::ranges::find(all_methods(), kind, &Method::kind)->name;
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
        if (!method.define.empty() && choice(methods, method.kind) == method.name) {
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
