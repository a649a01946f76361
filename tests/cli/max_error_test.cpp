// SPDX-License-Identifier: MIT
// --max-error as a user meets it.
#include <filesystem>

#include "cli/program.h"

namespace stagelight::cli {
namespace {

constexpr auto stage = "11_full_tracer";

class Stage11MaxError : public Cli {
protected:
    Stage11MaxError() {
        folder.write("scene.toml",
                     "[camera]\nposition = [0, 0, 4]\nlook_at = [0, 0, 0]\n"
                     "[materials.clay]\ntype = \"diffuse\"\n[[spheres]]\ncenter = [0, 0, 0]\n"
                     "radius = 1\nmaterial = \"clay\"\n[[lights]]\n"
                     "type = \"directional\"\ndirection = [-1, -1, -1]\n");
    }
    Outcome draw(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"scene.toml", "--size", small, "--out", "a.png"});
        return run(stage,
                   Start{arguments, {"XDG_CACHE_HOME=" + (folder.path() / "cache").string()}});
    }
};

// The second time by what the first has kept.
TEST_F(Stage11MaxError, SaysWhatItChoseAndHowWrongThatIs) {
    const Outcome first = draw({"--max-error", "0.001"});
    expect_done(first);
    expect_part(first.out, "for --max-error 0.001: ");
    expect_part(first.out, "\npredicted error ");
    expect_part(first.out, ", measured ");
    expect_part(first.out, "wrote a.png\n");
    const std::vector<std::string> kept = files();
    ASSERT_EQ(kept.size(), 5) << "scene, picture, two folders and one file of probes";
    const Outcome second = draw({"--max-error", "0.001", "--method", "math=strict"});
    expect_done(second);
    EXPECT_EQ(files().size(), 6) << "what the user chose is not probed: another file";
    EXPECT_EQ(draw({"--max-error", "0.001"}).out.substr(0, first.out.find('\n')),
              first.out.substr(0, first.out.find('\n')));
    EXPECT_EQ(files().size(), 6);
}

TEST_F(Stage11MaxError, ThatNothingMeetsStillDraws) {
    const Outcome outcome = draw({"--max-error", "1e-12"});
    EXPECT_EQ(outcome.code, 1) << outcome;
    expect_part(outcome.err, "error: no methods meet --max-error 1e-12; ");
    expect_part(outcome.err, " is the best reached\n");
    expect_part(outcome.out, "wrote a.png\n");
}

TEST_F(Stage11MaxError, IsANumberAboveNothing) {
    for (const char *bad : {"0", "-1", "nan", "inf", "1e-400", "little", ""}) {
        expect_one_line(draw({"--max-error", bad}), users_mistake,
                        std::string("--max-error: ") + bad + ": expected a number above 0");
    }
    expect_one_line(draw({"--max-error", "0.1", "--samples", "4"}), users_mistake, "--samples");
    expect_one_line(run("10_packets", {"--max-error", "0.1"}), users_mistake, "--max-error");
    EXPECT_EQ(files(), std::vector<std::string>{"scene.toml"});
}

}  // namespace
}  // namespace stagelight::cli
