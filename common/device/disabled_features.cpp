// SPDX-License-Identifier: MIT
#include "device/disabled_features.h"

namespace stagelight {
namespace {

struct Feature {
    const char *need;
    int first_stage;
    const char *what;
    const char *why;
};

constexpr Feature features[] = {
    {"HAS_SPHERES", 1, "spheres", "there is none"},
    {"HAS_PLANES", 1, "planes", "there is none"},
    {"HAS_LIGHTS", 2, "lights", "there is none, or nothing diffuse for them to light"},
    {"HAS_DIFFUSE", 2, "diffuse shading", "no material is diffuse or glossy"},
    {"HAS_REFLECTION", 3, "mirrors", "no material is mirror or glossy"},
    {"HAS_DIELECTRIC", 4, "refraction", "no material is dielectric"},
    {"HAS_MEDIA", 4, "glass in glass", "no dielectrics meet, and the eye is in none"},
    {"HAS_TRIANGLES", 5, "triangles", "there is no mesh"},
    {"HAS_TEXTURES", 6, "textures", "no material has a texture"},
    {"HAS_MESH_TEXTURES", 6, "texture coordinates of vertices", "no mesh has a texture"},
    {"HAS_WRAPS", 6, "clamped and mirrored textures", "every texture repeats"},
    {"HAS_CUTOUTS", 6, "cut-outs", "no mesh's material has an alpha_cutoff"},
    {"HAS_VERTEX_COLORS", 6, "colours of vertices", "every vertex is white"},
    {"HAS_TREE", 9, "tree", "neither spheres nor triangles"},
    {"HAS_DIELECTRIC_MESH", 11, "smooth glass", "no mesh is dielectric"},
    {"HAS_SMOOTH_MESH", 11, "smooth shadows", "no smooth mesh is lit, or terminator=none"},
};

}  // namespace

std::vector<std::pair<std::string, std::string>> disabled_features(const SceneNeeds &needs,
                                                                   int stage) {
    std::vector<std::pair<std::string, std::string>> disabled;
    for (const auto &[need, first_stage, what, why] : features) {
        if (stage >= first_stage && value_of(needs, need) == 0) {
            disabled.emplace_back(what, why);
        }
    }
    if (value_of(needs, "HAS_LIGHTS") > 0
        && value_of(needs, "HAS_POINT_LIGHT") != value_of(needs, "HAS_DIRECTIONAL_LIGHT")) {
        disabled.emplace_back("branch on the type of light", "all lights are of one type");
    }
    if (value_of(needs, "STACK_SIZE") == 1 && stage >= 3) {
        disabled.emplace_back("stack", "no ray splits in two: it has one place");
    }
    return disabled;
}

}  // namespace stagelight
