// SPDX-License-Identifier: MIT
// The command line as a whole: what a program does of itself, and what it refuses.
#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "cli/picture_file.h"
#include "cli/program.h"
#include "scene/stages.h"

namespace stagelight::cli {
namespace {

using Files = std::vector<std::string>;

class EveryStage : public Cli, public testing::WithParamInterface<std::string> {};

// CLI11 2.4 and later indent long names further.
bool starts_a_line(const std::string &text, const std::string &part) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.find(part) == line.find_first_not_of(' ') && line.starts_with("  ")) {
            return true;
        }
    }
    return false;
}

const auto its_stage = [](const auto &stage) { return "Stage" + stage.param; };

INSTANTIATE_TEST_SUITE_P(Programs, EveryStage, testing::ValuesIn(stage_names()), its_stage);

TEST_P(EveryStage, DrawsItsDefaultSceneToOut) {
    const Outcome outcome = run(GetParam(), {"--size", small});
    expect_done(outcome);
    const std::string picture = "out/" + GetParam() + ".png";
    expect_part(outcome.out, "\n32x20, 1 sample a pixel: ");
    expect_part(outcome.out, "\nwrote " + picture + "\n");
    // 07 says first that there is no display.
    EXPECT_EQ(std::ranges::count(outcome.out, '\n'), GetParam() == "07_interop" ? 4 : 3) << outcome;
    EXPECT_EQ(files(), (Files{"out", picture}));
    EXPECT_EQ(read_picture_file(folder.path() / picture).width, 32);
}

TEST_P(EveryStage, HelpListsEveryOption) {
    const Outcome outcome = run(GetParam(), {"--help"});
    expect_done(outcome);
    for (const char *option :
         {"size", "out", "samples", "depth", "device", "frames", "method", "kernels", "stats",
          "list-devices", "window", "display", "texture", "scale", "verbose", "quiet", "version"}) {
        EXPECT_TRUE(starts_a_line(outcome.out, fmt::format("--{} ", option))) << option;
    }
    for (const char *part : {"\n  scene ", "--help "}) {
        expect_part(outcome.out, part);
    }
    expect_part(outcome.out, "/scenes/" + GetParam() + ".toml");
    EXPECT_EQ(files(), Files{});
}

TEST_P(EveryStage, SaysItsVersion) {
    const Outcome outcome = run(GetParam(), {"--version"});
    expect_done(outcome);
    EXPECT_EQ(outcome.out, "Stagelight " STAGELIGHT_VERSION "\n");
}

// A line each, with its source, from the stage on that has it.
TEST_P(EveryStage, ListsItsMethods) {
    const Outcome outcome = run(GetParam(), {"--method", "list"});
    expect_done(outcome);
    for (const auto &[method, first_stage] : {std::pair{"math=strict ", "01"},
                                              {"origin=integer ", "02"},
                                              {"interior=paper ", "04"},
                                              {"filtering=hand ", "06"},
                                              {"encode=2.2 ", "08"},
                                              {"triangle=woop ", "09"},
                                              {"width=16 ", "10"},
                                              {"fresnel=exact ", "11"},
                                              {"terminator=hanika ", "11"}}) {
        EXPECT_EQ(outcome.out.find(method) != std::string::npos, GetParam() >= first_stage)
            << method;
    }
    expect_part(outcome.out, "  default  every operation rounded");
    EXPECT_EQ(files(), Files{});
}

struct BadOption {
    std::string name;
    std::vector<std::string> arguments;
    std::string text;
    std::string stage = "01_primitives";
};

void PrintTo(const BadOption &option, std::ostream *stream) {
    *stream << option.name;
}

class BadOptions : public Cli, public testing::WithParamInterface<BadOption> {};

TEST_P(BadOptions, AreToldInOneLine) {
    expect_one_line(run(GetParam().stage, GetParam().arguments), users_mistake, GetParam().text);
    EXPECT_EQ(files(), Files{});
}

const auto its_name = [](const auto &option) { return option.param.name; };

BadOption bad_size(const std::string &name, const std::string &size) {
    return {"size_" + name,
            {"--size", size},
            fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, 1 to 16384 each", size)};
}

INSTANTIATE_TEST_SUITE_P(
    Stage01, BadOptions,
    testing::Values(
        bad_size("zero", "0x0"), bad_size("enormous", "99999x99999"),
        bad_size("one_too_many", "16385x1"), bad_size("negative", "32x-20"),
        bad_size("no_height", "32x"), bad_size("three", "32x20x3"), bad_size("letters", "axb"),
        bad_size("space", "32 x20"), bad_size("nothing", ""),
        BadOption{"size_missing", {"--size"}, "--size"},
        BadOption{"unknown", {"--sise", small}, "--sise"},
        BadOption{"two_scenes", {"a.toml", "b.toml"}, "b.toml"},
        BadOption{"samples_zero", {"--samples", "0"}, "--samples"},
        BadOption{"samples_enormous", {"--samples", "65537"}, "--samples"},
        BadOption{"samples_letters", {"--samples", "many"}, "--samples"},
        BadOption{"samples_fraction", {"--samples", "1.5"}, "--samples"},
        BadOption{"depth_negative", {"--depth", "-1"}, "--depth"},
        BadOption{"depth_enormous", {"--depth", "65"}, "--depth"},
        BadOption{"frames_zero", {"--frames", "0"}, "--frames"},
        BadOption{"method_kind",
                  {"--method", "exterior=full"},
                  "--method exterior=full: expected one of sphere=geometric|textbook, "
                  "normalise=exact|native, math=strict|mad|relaxed|fp64\n"},
        BadOption{"method_too_early",
                  {"--method", "interior=paper"},
                  "--method interior=paper: unsupported by 01_primitives; "
                  "04_refraction_beer is the first stage that has it"},
        BadOption{"method_missing", {"--method"}, "--method"},
        BadOption{
            "out_jpg", {"--out", "a.jpg"}, "a.jpg: expected a name that ends in .png or .exr"},
        BadOption{"out_nothing", {"--out", ""}, "expected a name that ends in .png or .exr"}),
    its_name);

INSTANTIATE_TEST_SUITE_P(Stage04, BadOptions,
                         testing::Values(BadOption{
                             "method_unknown",
                             {"--method", "interior=none"},
                             "--method interior=none: expected one of interior=full|paper\n",
                             "04_refraction_beer"}),
                         its_name);

INSTANTIATE_TEST_SUITE_P(
    Stage08, BadOptions,
    testing::Values(BadOption{"method_unknown",
                              {"--method", "decode=gamma"},
                              "--method decode=gamma: expected one of decode=srgb|2.2\n",
                              "08_gamma"},
                    BadOption{"method_too_early",
                              {"--method", "encode=2.2"},
                              "--method encode=2.2: unsupported by 06_textures; "
                              "08_gamma is the first stage that has it",
                              "06_textures"}),
    its_name);

}  // namespace
}  // namespace stagelight::cli
