// SPDX-License-Identifier: MIT
// Where a picture can't be written: one line, and nothing left behind.
#include <fstream>
#include <iterator>

#include "cli/picture_file.h"
#include "cli/program.h"

namespace stagelight::cli {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<std::string>;

class Stage01Output : public Cli {
protected:
    void expect_refused(const std::vector<std::string> &arguments, const std::string &text) const {
        const Files before = files();
        expect_one_line(run("01_primitives", arguments), users_mistake, text);
        EXPECT_EQ(files(), before);
    }
};

TEST_F(Stage01Output, WantsAFolderThatIsThere) {
    expect_refused({"--out", "missing/a.png"}, "missing/a.png: missing does not exist");
    expect_refused({"--stats", "missing/a.json", "--out", "a.png"},
                   "missing/a.json: missing does not");
    folder.write("file", "");
    expect_refused({"--out", "file/a.png"}, "file/a.png: file is not a folder");
}

// Root may write anywhere but here: the kernel makes these folders up.
TEST_F(Stage01Output, WantsAFolderThatTakesFiles) {
    expect_refused({"--out", "/proc/a.png"},
                   "/proc/a.png: the folder /proc cannot be written to: ");
    expect_refused({"--out", "/sys/a.exr"}, "/sys/a.exr: the folder /sys cannot be written to: ");
    expect_refused({"--stats", "/proc/a.json", "--out", "a.png"}, "/proc/a.json");
}

TEST_F(Stage01Output, WantsARegularFile) {
    fs::create_directory(folder.path() / "folder.png");
    fs::create_symlink("/dev/full", folder.path() / "link.png");
    expect_refused({"--out", "folder.png"}, "folder.png: expected a regular file");
    expect_refused({"--out", "link.png"}, "link.png: expected a regular file");
    expect_refused({"--stats", "/dev/full", "--out", "a.png"},
                   "/dev/full: expected a regular file");
}

// The default folder is made where it is missing; here its name is taken.
TEST_F(Stage01Output, SaysWhatIsWrongWithTheDefaultFolder) {
    folder.write("out", "");
    expect_refused({}, "out/01_primitives.png: out is not a folder");
}

TEST_F(Stage01Output, SaysWhyTheDefaultFolderCantBeMade) {
    expect_one_line(
        run("01_primitives", Start{{},
                                   {"LD_PRELOAD=" STAGELIGHT_FAULTS, "STAGELIGHT_FAULT=mkdir:out",
                                    "ASAN_OPTIONS=verify_asan_link_order=0"}}),
        users_mistake, "out/01_primitives.png: the folder out can't be made: Permission denied");
    EXPECT_EQ(files(), Files{});
}

// A picture may take minutes, and so may what is loaded for it.
TEST_F(Stage01Output, IsCheckedBeforeAnythingIsLoaded) {
    for (const std::vector<std::string> &output :
         {std::vector<std::string>{"--out", "missing/a.png"},
          {"--window", "--out", "missing/a.png"},
          {"--stats", "missing/a.png", "--out", "b.png"},
          {"--max-error", "0.01", "--out", "missing/a.png"},
          {"--export-pov", "missing/a.png"}}) {
        std::vector<std::string> arguments = output;
        arguments.push_back("no_such_scene.toml");
        expect_one_line(run("11_full_tracer", arguments), users_mistake,
                        "missing/a.png: missing does not exist");
    }
    folder.write("out", "");
    expect_one_line(run("07_interop", {"no_such_scene.toml"}), users_mistake,
                    "out/07_interop.png: out is not a folder");
}

// However the name is written: the second would take the place of the first.
TEST_F(Stage01Output, WantsAnotherFileForEach) {
    expect_refused({"--out", "a.png", "--stats", "./a.png"},
                   "--stats ./a.png: --out is the same file, expected another");
    const fs::path scene = folder.write("scene.toml", "");
    expect_refused({"scene.toml", "--stats", scene}, "the scene is the same file");
    expect_refused({"scene.toml", "--export-pov", "scene.toml"}, "the scene is the same file");
    expect_refused({"--stats", "b", "--export-pov", "b"}, "--stats is the same file");
}

// No file may grow beyond 1 MiB, as on a disk with no more room: this EXR does, and what PoCL
// writes for itself does not.
TEST_F(Stage01Output, KeepsTheOldPictureWhenTheDiskIsFull) {
    const fs::path old = folder.write("a.exr", "the old picture");
    expect_done(run("01_primitives", {"--size", "1024x640", "--out", "b.exr"}));
    ASSERT_GT(fs::file_size(folder.path() / "b.exr"), 2u << 20);
    const Start start{{"--size", "1024x640", "--out", "a.exr"}, {}, 1 << 20};
    expect_one_line(run("01_primitives", start), users_mistake,
                    "a.exr: cannot be written: File too large");
    EXPECT_EQ(files(), (Files{"a.exr", "b.exr"}));
    std::ifstream in(old);
    EXPECT_EQ((std::string{std::istreambuf_iterator<char>(in), {}}), "the old picture");
}

}  // namespace
}  // namespace stagelight::cli
