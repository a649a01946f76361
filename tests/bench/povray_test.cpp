// SPDX-License-Identifier: MIT
// On a machine whose POV-Ray is a fake.
#include "bench/povray.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "image/image_io.h"
#include "scene/errors.h"
#include "scene/temporary_folder.h"

namespace stagelight::bench {
namespace {

class PovRay : public testing::Test {
protected:
    PovRay() : path_(std::getenv("PATH")) {
        setenv("PATH", (folder.path().string() + ":" + path_).c_str(), 1);
    }
    ~PovRay() override { setenv("PATH", path_.c_str(), 1); }

    // A program that does `script` for POV-Ray.
    void fake(const std::string &script) const {
        const auto file = folder.write("povray", "#!/bin/bash\n" + script);
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    }
    PovRayPicture run() const { return run_povray(folder.path() / "a.pov", 3, 2, 5); }

    TemporaryFolder folder;

private:
    std::string path_;
};

constexpr auto times = R"SH(
echo "  Parse Time:       0 hours  0 minutes  0 seconds (0.137 seconds)" >&2
echo "              using 1 thread(s) with 0.043 CPU-seconds total" >&2
echo "  Trace Time:       0 hours  1 minutes 10 seconds (70.250 seconds)" >&2
)SH";

TEST_F(PovRay, TellsItsTimesAndPicture) {
    Image image(3, 2);
    image.at(2, 1) = {0.25F, 4, 0};
    write_image(image, folder.path() / "a.exr", Transfer::none);
    fake(R"([[ "$*" == "a.pov +W3 +H2 +WT5 +FE -A -D" ]] || exit 1)" + std::string(times));
    const PovRayPicture picture = run();
    EXPECT_DOUBLE_EQ(picture.parsing, 137);
    EXPECT_DOUBLE_EQ(picture.tracing, 70250);
    EXPECT_GT(picture.wall, 0);
    EXPECT_EQ(picture.image.pixels, image.pixels);
}

void expect_machine_error(const auto &run, const std::string &part) {
    try {
        run();
        ADD_FAILURE() << "expected: " << part;
    } catch (const MachineError &error) {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST_F(PovRay, ThatFailsIsTold) {
    fake("exit 3");
    expect_machine_error([&] { run(); }, "a.log says why");
}

TEST_F(PovRay, ThatIsMissingIsTold) {
    setenv("PATH", folder.path().c_str(), 1);
    expect_machine_error([&] { run(); }, "apt-get install povray");
}

TEST_F(PovRay, ThatSaysNoTimeIsTold) {
    fake("echo nothing");
    expect_machine_error([&] { run(); }, "no Parse Time");
}

TEST_F(PovRay, ThatDrawsNothingIsTold) {
    fake(times);
    expect_machine_error([&] { run(); }, "POV-Ray's picture: ");
}

}  // namespace
}  // namespace stagelight::bench
