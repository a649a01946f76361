// SPDX-License-Identifier: MIT
#include "device/methods.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "scene/errors.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

const std::vector<Method> &all_methods() {
    static const std::vector<Method> methods = {
        {"sphere", "haines", packet_stage, "",
         "Haines et al., Ray Tracing Gems 2019, chapter 7: no difference of large numbers"},
        {"sphere", "geometric", 1, "",
         "the paper, section 2: by the perpendicular from the centre"},
        {"sphere", "textbook", 1, "", "the quadratic formula as in school"},
        {"triangle", "woop", tree_stage, "", "Woop, Benthin and Wald 2013: watertight"},
        {"triangle", "moeller_trumbore", tree_stage, "",
         "Möller and Trumbore 1997, with no threshold"},
        {"triangle", "threshold", tree_stage, "",
         "Möller and Trumbore 1997, and no determinant below 1e-5 (1e-6 in their code)"},
        {"box", "robust", tree_stage, "",
         "by comparing, padded by 2 ulp of each coordinate (after Ize 2013)"},
        {"box", "ordered", tree_stage, "", "Kay and Kajiya 1986, by comparing"},
        {"origin", "error_bound", 2, "",
         "PBRT 3rd edition, section 3.9: by what rounding can have done to the position"},
        {"origin", "scaled", 2, "", "off the surface by 2e-6 of the largest number in play"},
        {"origin", "fixed", 2, "", "off the surface by 0.001"},
        {"origin", "integer", 2, "", "Wächter and Binder, Ray Tracing Gems 2019, chapter 6"},
        {"terminator", "hanika", cutoff_stage, "",
         "Hanika, Ray Tracing Gems II 2021, chapter 4: shadow rays start on the smooth surface"},
        {"terminator", "chiang", cutoff_stage, "",
         "Chiang, Li and Burley 2019: light fades out before a facet turns away"},
        {"terminator", "none", cutoff_stage, "", "as the facets are lit, and shadow each other"},
        {"fresnel", "schlick", glass_stage, "", "Schlick 1994, as the paper has it"},
        {"fresnel", "exact", cutoff_stage, "",
         "Fresnel's equations, for light that is not polarised"},
        {"fresnel", "none", glass_stage, "", "no reflection, short of total internal reflection"},
        {"interior", "full", glass_stage, "-D METHOD_INTERIOR_PAPER=0",
         "Snell, Schlick and Beer at every wall, to the depth limit"},
        {"interior", "paper", glass_stage, "-D METHOD_INTERIOR_PAPER=1",
         "the paper, section 5: once through the sphere, no reflection inside"},
        {"transmission", "exp", glass_stage, "", "Beer's law by exp"},
        {"transmission", "native_exp", glass_stage, "", "Beer's law by the device's native_exp"},
        {"transmission", "none", glass_stage, "", "glass that absorbs nothing"},
        {"filtering", "sampler", texture_stage, "", "of four texels, by the device's sampler"},
        {"filtering", "hand", texture_stage, "", "of four texels, in float"},
        {"decode", "srgb", gamma_stage, "",
         "IEC 61966-2-1, a table of the 256 codes: texels are sRGB, as pictures mostly are"},
        {"decode", "2.2", gamma_stage, "", "the paper, section 8: texels are light to 1 / 2.2"},
        {"encode", "srgb", gamma_stage, "", "IEC 61966-2-1: the picture is for an sRGB screen"},
        {"encode", "table", gamma_stage, "",
         "IEC 61966-2-1, by straight lines between 257 points of its curve"},
        {"encode", "2.2", gamma_stage, "", "the paper, section 8: light to 1 / 2.2"},
        {"normalise", "exact", 1, "", "by 1 / sqrt"},
        {"normalise", "native", 1, "", "by the device's native_rsqrt"},
        {"math", "strict", 1, "",
         "every operation rounded as IEEE 754 has it; division and square root within 3 ulp where "
         "the device lacks CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT"},
        {"math", "mad", 1, "-D METHOD_MATH_MAD=1 -cl-mad-enable",
         "-cl-mad-enable: products and sums may be contracted"},
        {"math", "relaxed", 1, "-D METHOD_MATH_MAD=1 -cl-fast-relaxed-math",
         "-cl-fast-relaxed-math: and reordered, with no thought of NaN and infinity"},
        {"math", "fp64", 1, "-D METHOD_MATH_FP64=1",
         "in double, on what lies in memory as float; where the device has cl_khr_fp64"},
        {"depth", "contribution", cutoff_stage, "",
         "until a ray carries less than 1/4096 of a pixel"},
        {"depth", "coarse", cutoff_stage, "", "until a ray carries less than 1/64 of a pixel"},
        {"depth", "fixed", cutoff_stage, "", "every ray, to the depth limit"},
        {"walk", "beam", packet_stage, "",
         "down the tree with four packets as one beam (Reshetov et al. 2005), then each by itself"},
        {"walk", "packet", packet_stage, "",
         "down the tree with each packet by itself (Wald et al. 2001)"},
        {"width", "device", packet_stage, "",
         "rays side by side in a work-item: 1 on a GPU, else the width that the device prefers"},
        {"width", "1", packet_stage, "", "one ray in a work-item"},
        {"width", "4", packet_stage, "", "2x2 rays side by side"},
        {"width", "8", packet_stage, "", "4x2 rays side by side"},
        {"width", "16", packet_stage, "", "4x4 rays side by side"},
    };
    return methods;
}

std::string choice_of(const Method &method) {
    return method.kind + '=' + method.name;
}

// KIND=NAME|NAME, of one kind, or of all where a stage has none of that name.
std::string choices_of(const std::string &kind, int stage) {
    const std::vector<Method> methods = methods_of(stage);
    const bool is_kind = std::ranges::find(methods, kind, &Method::kind) != methods.end();
    std::string choices;
    std::string before;
    for (const Method &method : methods) {
        if (!is_kind || method.kind == kind) {
            const char *separator = choices.empty() ? "" : ", ";
            choices += method.kind == before ? '|' + method.name : separator + choice_of(method);
            before = method.kind;
        }
    }
    return choices;
}

Transfer transfer_of(const char *kind, int stage, const Methods &methods) {
    if (stage < gamma_stage) {
        return Transfer::none;
    }
    const std::string name = choice(methods, kind);
    return name == "2.2" ? Transfer::power : name == "table" ? Transfer::table : Transfer::srgb;
}

}  // namespace

std::vector<Method> methods_of(int stage) {
    std::vector<Method> methods = all_methods();
    std::erase_if(methods, [stage](const Method &method) { return method.first_stage > stage; });
    return methods;
}

std::string choice(const Methods &methods, const std::string &kind, int stage) {
    const auto chosen = methods.find(kind);
    if (chosen != methods.end()) {
        return chosen->second;
    }
    const auto first = std::ranges::find_if(all_methods(), [&](const Method &method) {
        return method.kind == kind && method.first_stage <= stage;
    });
    assert(first != all_methods().end());
    return first->name;
}

Methods with_defaults(Methods methods, int stage) {
    for (const Method &method : methods_of(stage)) {
        methods.try_emplace(method.kind, method.name);
    }
    return methods;
}

Methods files_of(Methods methods, const SceneNeeds &needs) {
    if (value_of(needs, "HAS_TEXTURES") == 0) {
        methods["filtering"] = "none";  // kernels/filtering/none.cl
    }
    if (value_of(needs, "HAS_SMOOTH_MESH") == 0) {
        methods["terminator"] = "none";
    }
    return methods;
}

bool matters(const std::string &kind, const SceneNeeds &needs) {
    const auto has = [&needs](const char *name) { return value_of(needs, name) != 0; };
    const bool glass = has("HAS_DIELECTRIC");
    const bool bounces = glass || has("HAS_REFLECTION");
    const bool in_a_tree = has("HAS_TRIANGLES") || has("HAS_SPHERES");
    const std::map<std::string, bool> known = {
        {"sphere", has("HAS_SPHERES")},
        {"triangle", has("HAS_TRIANGLES")},
        {"box", in_a_tree},
        {"walk", in_a_tree},
        {"origin", has("HAS_LIGHTS") || bounces},
        {"terminator", has("HAS_SMOOTH_MESH")},
        {"fresnel", glass},
        {"interior", glass && has("HAS_SPHERES")},
        {"transmission", glass},
        {"filtering", has("HAS_TEXTURES")},
        {"decode", has("HAS_TEXTURES")},
        {"depth", bounces},
    };
    const auto found = known.find(kind);
    return found == known.end() || found->second;
}

void choose_method(Methods &methods, const std::string &choice, int stage) {
    const auto chosen = std::ranges::find(all_methods(), choice, choice_of);
    if (chosen == all_methods().end()) {
        throw UserError(fmt::format("--method {}: expected one of {}", choice,
                                    choices_of(choice.substr(0, choice.find('=')), stage)));
    }
    if (chosen->first_stage > stage) {
        throw UserError(
            fmt::format("--method {}: unsupported by {}; {} is the first stage that has it", choice,
                        stage_name(stage), stage_name(chosen->first_stage)));
    }
    methods[chosen->kind] = chosen->name;
}

std::string options_of(const Methods &methods) {
    std::string options;
    for (const Method &method : all_methods()) {
        if (!method.options.empty() && choice(methods, method.kind) == method.name) {
            options += ' ' + method.options;
        }
    }
    return options;
}

bool has_smooth_shadows(const Methods &methods) {
    return choice(methods, "terminator") != "none";
}

int cutoff_of(const Methods &methods) {
    const std::string depth = choice(methods, "depth");
    return depth == "fixed" ? 0 : depth == "coarse" ? 64 : cutoff_one_in;
}

Transfer decode_of(int stage, const Methods &methods) {
    return transfer_of("decode", stage, methods);
}

Transfer encode_of(int stage, const Methods &methods) {
    return transfer_of("encode", stage, methods);
}

}  // namespace stagelight
