// SPDX-License-Identifier: MIT
// --split: figure 4 of the paper, left with gamma and right without.
#include <fstream>

#include <nlohmann/json.hpp>

#include "cli/picture_file.h"
#include "cli/program.h"
#include "display/xvfb.h"
#include "image/split.h"

namespace stagelight::cli {
namespace {

const std::string scene = std::string(STAGELIGHT_SOURCE_DIR) + "/scenes/08_decode.toml";

class Stage08Split : public Cli {
protected:
    PictureFile draw(const std::string &stage, std::vector<std::string> more = {},
                     const std::vector<std::string> &environment = {}) const {
        more.insert(more.begin(),
                    {scene, "--size", "100x60", "--out", "a.png", "--stats", "a.json"});
        expect_done(run(stage, Start{more, environment}));
        return read_picture_file(folder.path() / "a.png");
    }
    nlohmann::json rays() const {
        std::ifstream file(folder.path() / "a.json");
        return nlohmann::json::parse(file).at("rays");
    }
};

// Each half is the whole picture's: that of 08, and that of 06, which has no gamma at either end.
TEST_F(Stage08Split, HasEachHalfFromItsOwnPicture) {
    const PictureFile without = draw("06_textures");
    const PictureFile with = draw("08_gamma");
    const nlohmann::json rays_of_one = rays();
    const PictureFile split = draw("08_gamma", {"--split"});
    EXPECT_EQ(rays(), rays_of_one) << "a pixel was traced twice, or not at all";
    const SplitLine line = split_line(split_share, 100);
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 100; ++x) {
            const bool on_line = x >= line.begin && x < line.end;
            const PictureFile &half = x < line.begin ? with : without;
            for (int channel = 0; channel < 3; ++channel) {
                ASSERT_EQ(split.at(x, y, channel), on_line ? 1 : half.at(x, y, channel))
                    << x << ", " << y;
            }
        }
    }
    EXPECT_GT(largest_difference(with, without), 0.1F);
}

TEST_F(Stage08Split, IsTheSameFromAWindow) {
    const PictureFile split = draw("08_gamma", {"--split", "--device", "pocl"});
    const Xvfb xvfb;
    const PictureFile shown =
        draw("08_gamma", {"--split", "--device", "pocl", "--display", "shared", "--frames", "2"},
             {"DISPLAY=" + xvfb.display(), std::string("OPENCL_LAYERS=") + STAGELIGHT_LAYER});
    EXPECT_EQ(largest_difference(split, shown), 0);
}

TEST_F(Stage08Split, IsForTheEye) {
    expect_one_line(run("08_gamma", {"--split", "--out", "a.exr"}), users_mistake,
                    "--split --out a.exr");
    expect_done(run("08_gamma", {"--split", "--size", small, "--out", "A.PNG"}));
}

TEST_F(Stage08Split, IsWhatStage08Teaches) {
    expect_one_line(run("07_interop", {"--split"}), users_mistake, "--split");
}

}  // namespace
}  // namespace stagelight::cli
