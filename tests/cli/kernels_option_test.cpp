// SPDX-License-Identifier: MIT
// --kernels: the kernels of a checkout on disk, for work on them.
#include <algorithm>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "cli/picture_file.h"
#include "cli/program.h"

namespace stagelight::cli {
namespace {

namespace fs = std::filesystem;

class Stage01Kernels : public Cli {
protected:
    Stage01Kernels() {
        const fs::path checkout = STAGELIGHT_SOURCE_DIR;
        fs::create_directory(folder.path() / "mine");
        for (const char *part : {"kernels", "stages"}) {
            fs::copy(checkout / part, folder.path() / "mine" / part, fs::copy_options::recursive);
        }
    }

    void replace(const std::string &file, const std::string &old, const std::string &fresh) const {
        const fs::path path = folder.path() / "mine" / file;
        std::ifstream in(path);
        std::string text{std::istreambuf_iterator<char>(in), {}};
        const std::size_t place = text.find(old);
        ASSERT_NE(place, std::string::npos) << old << " in " << file;
        text.replace(place, old.size(), fresh);
        std::ofstream(path) << text;
    }
    PictureFile draw(std::vector<std::string> arguments,
                     const std::vector<std::string> &environment = {}) const {
        arguments.insert(arguments.end(), {"--size", small, "--out", "a.exr"});
        expect_done(run("01_primitives", Start{arguments, environment}));
        return read_picture_file(folder.path() / "a.exr");
    }
    // Why nothing was drawn with them.
    Outcome refused() const {
        const Outcome outcome =
            run("01_primitives", {"--kernels", "mine", "--size", small, "--out", "a.exr"});
        EXPECT_EQ(outcome.code, users_mistake) << outcome;
        EXPECT_FALSE(fs::exists(folder.path() / "a.exr"));
        return outcome;
    }
};

TEST_F(Stage01Kernels, OnDiskAreThoseInTheProgram) {
    EXPECT_EQ(largest_difference(draw({}), draw({"--kernels", "mine"})), 0);
}

TEST_F(Stage01Kernels, OnDiskChangeThePicture) {
    const PictureFile usual = draw({});
    replace("stages/01_primitives/kernel.cl", "color = XYZ(scene.background)",
            "color = 1.0f - XYZ(scene.background)");
    const PictureFile mine = draw({"--kernels", "mine"});
    EXPECT_GT(largest_difference(usual, mine), 0.5F);
    EXPECT_EQ(largest_difference(mine, draw({}, {"STAGELIGHT_KERNELS=mine"})), 0);
    replace("kernels/camera.cl", "point.x * XYZ(camera->right)",
            "2.0f * point.x * XYZ(camera->right)");
    EXPECT_GT(largest_difference(usual, draw({"--kernels", "mine/"})), 0.5F);
}

// The compiler's log counts lines as the file does: after an #include, and after one that #if
// leaves out.
TEST_F(Stage01Kernels, ThatDoNotBuildAreToldByFileAndLine) {
    for (const auto &[file, right] :
         {std::pair{"kernels/camera.cl", "normalize(direction)"},
          std::pair{"kernels/closest_hit.cl", "closest.shape = SHAPE_NONE"}}) {
        const std::string wrong = "nowhere_declared";
        replace(file, right, wrong);
        std::ifstream in(folder.path() / "mine" / file);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        const auto line = 1 + std::count(text.begin(), text.begin() + long(text.find(wrong)), '\n');
        const Outcome outcome = refused();
        expect_part(outcome.err, "error: the kernel does not build:\n");
        expect_part(outcome.err, fmt::format("{}:{}:", file, line));
        expect_part(outcome.err, wrong);
        replace(file, wrong, right);
    }
}

TEST_F(Stage01Kernels, ThatLackAnArgumentAreTold) {
    replace("stages/01_primitives/kernel.cl", "PICTURE image", "PICTURE picture");
    replace("stages/01_primitives/kernel.cl", "write_pixel(image", "write_pixel(picture");
    expect_one_line(refused(), users_mistake, "the kernel 'render' has no argument 'image'");
}

TEST_F(Stage01Kernels, ThatHaveAnArgumentTooManyAreTold) {
    replace("stages/01_primitives/kernel.cl", "PICTURE image", "PICTURE image, const float more");
    expect_one_line(refused(), users_mistake, "the kernel 'render' has an argument 'more'");
}

TEST_F(Stage01Kernels, WithoutTheKernelItselfAreTold) {
    replace("stages/01_primitives/kernel.cl", "void render(", "void draw(");
    expect_one_line(refused(), users_mistake, "there is no kernel 'render'");
}

TEST_F(Stage01Kernels, ThatAreMissingAreToldByName) {
    fs::remove(folder.path() / "mine/kernels/sphere.cl");
    expect_one_line(refused(), users_mistake,
                    "mine/kernels/sphere.cl: can't be read; --kernels, or STAGELIGHT_KERNELS, "
                    "expects a folder that holds "
                    "kernels/ and stages/");
    fs::remove_all(folder.path() / "mine");
    expect_one_line(refused(), users_mistake, "mine/stages/01_primitives/kernel.cl: can't be read");
}

}  // namespace
}  // namespace stagelight::cli
