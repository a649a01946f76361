// SPDX-License-Identifier: MIT
// Stage 11 as a user meets it: what it warns of, how deep it goes, and what it leaves out.
#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace stagelight::cli {
namespace {

using nlohmann::json;

constexpr auto stage = "11_full_tracer";
constexpr auto camera = "[camera]\nposition = [3, 2, 4]\nlook_at = [0, 0, 0]\n";

class Stage11Warning : public Cli {
protected:
    // A pyramid of glass with these faces.
    Outcome draw(const std::string &faces) const {
        folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + faces);
        folder.write("scene.toml", camera
                                       + std::string("[materials.glass]\ntype = \"dielectric\"\n"
                                                     "[[meshes]]\nfile = \"a.obj\"\n"
                                                     "material = \"glass\"\n"));
        return run(stage, {"scene.toml", "--size", small, "--out", "a.png"});
    }
};

TEST_F(Stage11Warning, NamesGlassThatIsNotClosed) {
    const Outcome outcome = draw("f 1 3 2\nf 1 2 4\nf 2 3 4\n");
    EXPECT_EQ(outcome.code, 0) << outcome;
    EXPECT_TRUE(outcome.err.starts_with("warning: scene.toml:7:8: ")
                && outcome.err.find('\n') + 1 == outcome.err.size())
        << outcome;
    expect_part(outcome.err, "not closed: 3 of its edges");
    expect_part(outcome.out, "wrote a.png");
}

// One for each of so many files, whose textures are missing.
class Stage11Warnings : public Cli {
protected:
    struct Said {
        std::string err;
        std::vector<std::string> in_stats;
    };

    Said draw(int files, std::vector<std::string> arguments = {}) const {
        std::string scene = camera;
        folder.write("a.mtl", "newmtl m\nmap_Kd none.png\n");
        for (int i = 0; i < files; ++i) {
            const std::string name = "a" + std::to_string(i) + ".obj";
            folder.write(name, "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\n"
                               "f 1/1 2/1 3/1\n");
            scene += "[[meshes]]\nfile = \"" + name + "\"\n";
        }
        folder.write("scene.toml", scene);
        arguments.insert(arguments.end(), {"scene.toml", "--size", small, "--out", "a.png",
                                           "--stats", "stats.json"});
        const Outcome outcome = run(stage, arguments);
        EXPECT_EQ(outcome.code, 0) << outcome;
        return {outcome.err,
                json::parse(std::ifstream(folder.path() / "stats.json")).at("warnings")};
    }
};

TEST_F(Stage11Warnings, AreAtMostFiveLinesAndAllInTheStats) {
    const Said five = draw(5);
    EXPECT_EQ(std::ranges::count(five.err, '\n'), 5) << five.err;
    EXPECT_EQ(five.in_stats.size(), 5U);
    EXPECT_EQ(five.err.find("more"), std::string::npos) << five.err;
    const Said seven = draw(7);
    EXPECT_EQ(std::ranges::count(seven.err, '\n'), 5) << seven.err;
    EXPECT_TRUE(seven.err.ends_with("\nwarning: 3 more; --stats FILE has all of them\n"))
        << seven.err;
    ASSERT_EQ(seven.in_stats.size(), 7U);
    expect_part(seven.in_stats[6], "a6.obj: no file none.png");
    EXPECT_TRUE(draw(0).in_stats.empty());
}

TEST_F(Stage11Warnings, AreNotPrintedWhenQuiet) {
    const Said said = draw(1, {"--quiet"});
    EXPECT_EQ(said.err, "");
    EXPECT_EQ(said.in_stats.size(), 1U);
}

TEST_F(Stage11Warning, IsNotForClosedGlass) {
    expect_done(draw("f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"));
}

// A ball of that material on a white floor, lit from above.
class Stage11Needs : public Cli {
protected:
    json stats(const std::string &material, std::vector<std::string> arguments = {},
               const std::string &more = "") const {
        folder.write("scene.toml",
                     camera + std::string("[materials.ball]\n") + material
                         + "[[spheres]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"ball\"\n"
                           "[[planes]]\nnormal = [0, 1, 0]\npoint = [0, -1, 0]\n"
                           "[[lights]]\ntype = \"directional\"\ndirection = [0, -1, 0]\n"
                         + more);
        arguments.insert(arguments.begin(), {"scene.toml", "--size", small, "--out", "a.png",
                                             "--stats", "stats.json", "--verbose"});
        const Outcome outcome = run(stage, arguments);
        expect_done(outcome);
        said_ = outcome.out;
        return json::parse(std::ifstream(folder.path() / "stats.json"));
    }
    const std::string &said() const { return said_; }

private:
    mutable std::string said_;
};

constexpr auto paint = "type = \"diffuse\"\n";
constexpr auto varnish = "type = \"glossy\"\ncolor = [0.5, 0.4, 0.3]\nspecularity = 0.5\n";

// A share of a quarter at most is handed on: a sixth bounce has 1/4096 of the weight.
TEST_F(Stage11Needs, GiveTheDepth) {
    EXPECT_EQ(stats(paint).at("max_depth"), 0);
    const json derived = stats(varnish);
    EXPECT_EQ(derived.at("max_depth"), 6);
    EXPECT_EQ(derived.at("needs").at("MAX_DEPTH"), 6);
    EXPECT_EQ(derived.at("dropped_rays"), 0);
    EXPECT_EQ(stats(varnish, {}, "[trace]\nmax_depth = 3\n").at("max_depth"), 3);
    EXPECT_EQ(stats(varnish, {"--depth", "2"}).at("max_depth"), 2);
}

TEST_F(Stage11Needs, AreToldWithWhatTheyDisable) {
    const json disabled = stats(paint).at("disabled_features");
    EXPECT_EQ(disabled, json({{"mirrors", "no material is mirror or glossy"},
                              {"refraction", "no material is dielectric"},
                              {"glass in glass", "no dielectrics meet, and the eye is in none"},
                              {"triangles", "there is no mesh"},
                              {"textures", "no material has a texture"},
                              {"texture coordinates of vertices", "no mesh has a texture"},
                              {"clamped and mirrored textures", "every texture repeats"},
                              {"cut-outs", "no mesh's material has an alpha_cutoff"},
                              {"colours of vertices", "every vertex is white"},
                              {"smooth glass", "no mesh is dielectric"},
                              {"smooth shadows", "no smooth mesh is lit, or terminator=none"},
                              {"branch on the type of light", "all lights are of one type"},
                              {"stack", "no ray splits in two: it has one place"}}));
    expect_part(said(), "not in the kernel, as this scene needs none: mirrors, refraction, "
                        "glass in glass, triangles, textures, ");
    const json with_glass =
        stats("type = \"dielectric\"\n", {}, "[[lights]]\ntype = \"point\"\nposition = [0, 5, 0]\n")
            .at("disabled_features");
    for (const char *what : {"refraction", "branch on the type of light", "stack"}) {
        EXPECT_FALSE(with_glass.contains(what)) << what;
    }
    EXPECT_TRUE(with_glass.contains("mirrors"));
}

// The floor and the light are white: nothing is brighter than 1.
TEST_F(Stage11Needs, BoundTheErrorOfTheImportanceCutoff) {
    const json glass = stats("type = \"dielectric\"\ncolor = [0.9, 0.9, 0.9]\n", {"--depth", "40"});
    const json &cut_off = glass.at("cut_off_rays");
    EXPECT_GT(cut_off.at("count"), 0);
    EXPECT_GT(cut_off.at("largest_sum_of_weights"), 0);
    EXPECT_LT(cut_off.at("largest_sum_of_weights"), 0.02);
    EXPECT_EQ(cut_off.at("radiance_bound"), 1);
    EXPECT_EQ(cut_off.at("error_at_most"), cut_off.at("largest_sum_of_weights"));
    EXPECT_EQ(glass.at("needs").at("CUTOFF_ONE_IN"), 4096);
    expect_part(said(), to_string(cut_off.at("count")) + " rays not traced, each below 1/4096");
    EXPECT_EQ(stats(paint).at("cut_off_rays").at("error_at_most"), 0);
}

}  // namespace
}  // namespace stagelight::cli
