// SPDX-License-Identifier: MIT
// Disks and devices that fail: one line, the right exit code, and no half file.
#include <algorithm>
#include <filesystem>
#include <ostream>

#include "cli/picture_file.h"
#include "cli/program.h"

namespace stagelight::cli {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<std::string>;

struct Fault {
    const char *name;     // of STAGELIGHT_FAULT
    int code;             // the exit code
    const char *message;  // a part of it
};

void PrintTo(const Fault &fault, std::ostream *out) {
    *out << fault.name;
}

// A textured mesh in a scene of its own, drawn by stage 06.
class Faults : public Cli {
protected:
    Faults() {
        const fs::path scenes = fs::path(STAGELIGHT_SOURCE_DIR) / "scenes";
        for (const char *file : {"cube.obj", "cube.mtl", "cube.png"}) {
            fs::copy_file(scenes / file, folder.path() / file);
        }
        folder.write("scene.toml", R"([camera]
position = [3, 2, 4]
look_at = [0, 0, 0]
[[lights]]
type = "directional"
direction = [-1, -2, -3]
[[meshes]]
file = "cube.obj"
)");
    }

    Outcome draw(const std::string &fault, const std::string &out,
                 const std::string &stats = "stats.json") const {
        return run("06_textures",
                   Start{{"scene.toml", "--size", "64x40", "--out", out, "--stats", stats},
                         {"LD_PRELOAD=" STAGELIGHT_FAULTS, "STAGELIGHT_FAULT=" + fault,
                          "ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0"}});
    }
};

class Stage06Fault : public Faults, public testing::WithParamInterface<Fault> {};

TEST_P(Stage06Fault, IsToldInOneLine) {
    const Files before = files();
    expect_one_line(draw(GetParam().name, "a.exr"), GetParam().code, GetParam().message);
    EXPECT_EQ(files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Disk, Stage06Fault,
    testing::Values(Fault{"read:scene.toml", users_mistake, "scene.toml: can't be read"},
                    Fault{"read:cube.obj", users_mistake, "cube.obj: can't be read"},
                    Fault{"read:cube.mtl", users_mistake, "cube.obj: can't be read"},
                    Fault{"write:.stagelight-", users_mistake,
                          "a.exr: cannot be written: No space left on device"},
                    Fault{"fsync:.stagelight-", users_mistake,
                          "a.exr: cannot be written: Input/output error"}));

INSTANTIATE_TEST_SUITE_P(
    Device, Stage06Fault,
    testing::Values(Fault{"clCreateContext", machines_lack, "try another --device"},
                    Fault{"clBuildProgram", machines_lack, "try another --device"},
                    Fault{"clCreateBuffer", machines_lack, "try another --device"},
                    Fault{"clEnqueueNDRangeKernel", machines_lack, "try another --device"},
                    Fault{"clFinish", machines_lack, "try another --device"},
                    Fault{"clEnqueueReadBuffer", machines_lack, "try another --device"}));

class Stage06UnreadTexture : public Faults {};

TEST_F(Stage06UnreadTexture, IsAWarning) {
    const Outcome outcome = draw("read:cube.png", "a.exr");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.err.find("cube.png is no"), std::string::npos) << outcome.err;
    read_picture_file(folder.path() / "a.exr");
}

class Stage06FullDisk : public Faults {};

TEST_F(Stage06FullDisk, IsToldOfAPngToo) {
    const Files before = files();
    expect_one_line(draw("write:.stagelight-", "a.png"), users_mistake,
                    "a.png: cannot be written: No space left on device");
    EXPECT_EQ(files(), before);
}

TEST_F(Stage06FullDisk, LeavesThePictureThatIsWholeWhenStatsFindNoRoom) {
    fs::create_directory(folder.path() / "other_disk");
    Files after = files();
    after.insert(std::ranges::upper_bound(after, "a.exr"), "a.exr");
    expect_one_line(draw("write:other_disk/.stagelight-", "a.exr", "other_disk/stats.json"),
                    users_mistake, "stats.json: cannot be written: No space left on device");
    EXPECT_EQ(files(), after);
    read_picture_file(folder.path() / "a.exr");
}

class Stage06ShortTransfer : public Faults {};

TEST_F(Stage06ShortTransfer, ChangesNothing) {
    expect_done(draw("", "a.exr"));
    const PictureFile whole = read_picture_file(folder.path() / "a.exr");
    for (const char *fault :
         {"short_read:scene.toml", "short_read:cube.png", "short_write:.stagelight-"}) {
        expect_done(draw(fault, "b.exr"));
        EXPECT_EQ(largest_difference(read_picture_file(folder.path() / "b.exr"), whole), 0)
            << fault;
    }
}

}  // namespace
}  // namespace stagelight::cli
