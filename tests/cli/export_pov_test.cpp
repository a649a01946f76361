// SPDX-License-Identifier: MIT
// --export-pov: a scene for POV-Ray, and no picture.
#include <algorithm>
#include <fstream>
#include <iterator>

#include "cli/program.h"

namespace stagelight::cli {
namespace {

using Files = std::vector<std::string>;

class Stage01ExportPov : public Cli {};
class Stage02ExportPov : public Cli {};
class Stage04ExportPov : public Cli {};

TEST_F(Stage02ExportPov, WritesTheSceneAndLeaves) {
    const Outcome outcome =
        run("02_shading_shadows", {"--export-pov", "a.pov", "--size", "64x40", "--depth", "2"});
    expect_done(outcome);
    EXPECT_EQ(outcome.out, "wrote a.pov\n");
    EXPECT_EQ(files(), Files{"a.pov"});
    std::ifstream stream(folder.path() / "a.pov");
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    expect_part(text, "// povray a.pov +W64 +H40 ");
    expect_part(text, "max_trace_level 3 ");
}

// Which has no light, but lights that turn normals into colours.
TEST_F(Stage01ExportPov, WritesNormalsAndDistances) {
    expect_done(run("01_primitives", {"--export-pov", "a.pov"}));
    EXPECT_EQ(files(), Files{"a.pov"});
    std::ifstream stream(folder.path() / "a.pov");
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    expect_part(text, "parallel point_at 0 shadowless");
    expect_part(text, "emission 0.5 diffuse 1");
}

TEST_F(Stage04ExportPov, IsRefusedForThePapersInterior) {
    expect_one_line(
        run("04_refraction_beer", {"--export-pov", "a.pov", "--method", "interior=paper"}),
        users_mistake, "POV-Ray has no --method interior=paper");
    EXPECT_EQ(files(), Files{});
}

}  // namespace
}  // namespace stagelight::cli
