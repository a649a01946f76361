// SPDX-License-Identifier: MIT
// Every method that is not the default, on a scene of the stage that teaches it: a small picture
// against the reference, by the rule of the goldens. Also of stage 10's packets, which have their
// own of some.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "device/device_choice.h"
#include "golden/suite.h"
#include "implementations.h"
#include "scene/scene_file.h"
#include "scene/stages.h"

namespace stagelight::golden {
namespace {

// One implementation shows a mistake in a method.
const char *const device = implementations.front();

struct Case {
    std::string scene;
    Methods methods;
    // The RMSE beside the reference of the default, of a method that the reference hasn't got.
    double rmse = 0;
    bool absorbs = true;
    std::string width = "1";  // others are stage 10's
};

void PrintTo(const Case &it, std::ostream *out) {
    *out << it.scene;
}

const std::vector<Case> cases{
    {"01_primitives", {{"sphere", "textbook"}}},
    {"01_primitives", {{"normalise", "native"}}},
    {"02_shading_shadows", {{"origin", "scaled"}}},
    {"02_shading_shadows", {{"origin", "fixed"}}},
    {"02_shading_shadows", {{"origin", "integer"}}},
    {"04_refraction_beer", {{"fresnel", "none"}}, 0.04488},
    {"04_interior", {{"transmission", "native_exp"}}},
    {"04_interior", {{"transmission", "none"}}, 0, false},
    {"04_interior", {{"math", "mad"}}},
    {"04_interior", {{"math", "fp64"}}},
    {"06_filtering", {{"filtering", "hand"}}},
    {"09_tree", {{"triangle", "moeller_trumbore"}, {"box", "ordered"}}},
    {"09_tree", {{"triangle", "threshold"}}},
    {"11_full_tracer", {{"depth", "fixed"}}},
    {"11_full_tracer", {{"depth", "coarse"}}, 0.000698},
    {"11_full_tracer", {{"terminator", "none"}}},
    {"11_full_tracer", {{"terminator", "chiang"}}},
    {"10_packets", {{"sphere", "geometric"}}},
    {"10_packets",
     {{"sphere", "geometric"},
      {"triangle", "moeller_trumbore"},
      {"box", "ordered"},
      {"origin", "scaled"},
      {"normalise", "native"},
      {"walk", "packet"}},
     0,
     true,
     "4"},
    {"10_packets", {{"triangle", "threshold"}}, 0, true, "4"},
    {"02_shading_shadows", {{"sphere", "textbook"}, {"origin", "fixed"}}, 0, true, "4"},
    {"02_shading_shadows", {{"origin", "integer"}}, 0, true, "4"},
};

std::string stage_of(const Case &it) {
    return std::string(stage_name(it.width == "1" ? stage_number(it.scene) : packet_stage));
}

std::string name_of(const Case &it) {
    std::string name = "Stage" + stage_of(it).substr(0, 2);
    for (const auto &[kind, method] : it.methods) {
        name += '_' + kind + '_' + name_in_tests(method);
    }
    return name + (it.width == "1" ? "" : "_width_" + it.width);
}

// The picture of the goldens is 320x192.
Scene small_scene(const Case &it) {
    Scene scene = load_scene(scenes_of(it.scene.substr(0, 2)).front().scene.parent_path()
                             / (it.scene + ".toml"));
    for (Material &material : scene.materials) {
        material.absorption *= it.absorbs ? 1 : 0;
    }
    scene.width = 48;
    scene.height = 30;
    return scene;
}

class MethodPicture : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Methods, MethodPicture, testing::ValuesIn(cases),
                         [](const auto &it) { return name_of(it.param); });

TEST_P(MethodPicture, MatchesTheReference) {
    const Case &it = GetParam();
    const std::string stage = stage_of(it);
    const Scene scene = small_scene(it);
    reference::Settings truly = reference_settings(stage, scene, it.methods);
    truly.width = scene.width;
    truly.height = scene.height;
    const reference::Result truth = reference::render<double>(scene, truly, shown_by(stage));
    RenderSettings settings;
    settings.width = scene.width;
    settings.height = scene.height;
    settings.max_depth = truly.max_depth;
    settings.methods = it.methods;
    settings.methods["width"] = it.width;
    const Image picture = Renderer(choose_device(device), stage, scene, settings).render().image;
    const Comparison comparison =
        compare(picture, truth.image, truth.edge, tolerance_of(it.scene, device));
    std::cout << to_string(comparison) << '\n';
    if (it.rmse > 0) {  // what it has given up, no more and no less
        EXPECT_NEAR(comparison.rmse, it.rmse, 0.02 * it.rmse);
        EXPECT_LT(comparison.worst_interior, 1) << to_string(comparison);
    } else {
        EXPECT_EQ(comparison.failure, "") << to_string(comparison);
    }
}

// One that nobody draws can be wrong.
TEST(MethodPictures, AreOfAllThatTheStagesDoNotDrawByDefault) {
    std::set<std::pair<std::string, std::string>> drawn;
    for (const Case &it : cases) {
        drawn.insert(it.methods.begin(), it.methods.end());
    }
    // Beside the goldens, in their size, and by the host: tests/kernels/transfer_test.cpp.
    const std::set<std::string> elsewhere{"width", "interior=paper", "fresnel=exact", "decode=2.2",
                                          "encode"};
    const int last = int(stage_names().size());
    for (const Method &method : methods_of(last)) {
        const bool is_default = method.name == choice({}, method.kind, last);
        const bool is_a_compilers = method.name == "relaxed";
        EXPECT_TRUE(is_default || is_a_compilers || elsewhere.contains(method.kind)
                    || elsewhere.contains(method.kind + '=' + method.name)
                    || drawn.contains({method.kind, method.name}))
            << method.kind << '=' << method.name;
    }
}

}  // namespace
}  // namespace stagelight::golden
