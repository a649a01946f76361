// SPDX-License-Identifier: MIT
// A long session: frames, resizes and reloads, half of them of kernels that do not build. Memory
// stays where it was.
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "device/device_choice.h"
#include "display/frame_pipeline.h"
#include "display/layer_loaded.h"
#include "display/screen.h"
#include "display/xvfb.h"
#include "implementations.h"
#include "scene/errors.h"
#include "scene/scene_file.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

constexpr int frames = 5000;
constexpr int frames_a_change = 50;  // 100 resizes and 100 reloads

// Of this process, bytes.
std::size_t resident() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// Of OpenGL's; Mesa counts their names up.
int textures_there_are() {
    int count = 0;
    for (GLuint name = 1; name < 10 * frames; ++name) {
        count += glIsTexture(name) == GL_TRUE;
    }
    return count;
}

void copy_kernels(const fs::path &to) {
    for (const char *part : {"kernels", "stages"}) {
        fs::create_directories(to);
        fs::copy(fs::path(STAGELIGHT_SOURCE_DIR) / part, to / part, fs::copy_options::recursive);
    }
}

class Stage07Endurance : public testing::TestWithParam<DisplayPath> {
protected:
    Stage07Endurance() {
        copy_kernels(folder.path() / "good");
        copy_kernels(folder.path() / "broken");
        std::ofstream(folder.path() / "broken/stages/01_primitives/kernel.cl") << "void oops(;\n";
    }

    void show(FramePipeline &pipeline) const {
        pipeline.start(scene.camera);
        if (pipeline.full()) {
            ASSERT_TRUE(pipeline.finish());
            screen.draw(pipeline.texture().id(), window.framebuffer_size(), window.color_bits(),
                        Transfer::srgb);
            window.swap();
        }
    }
    static void finish_all(FramePipeline &pipeline) {
        while (!pipeline.empty()) {
            ASSERT_TRUE(pipeline.finish());
        }
    }
    // The kernel stays, or is the same anew.
    void reload(FramePipeline &pipeline, int change) const {
        if (change % 2 == 0) {
            pipeline.rebuild(folder.path() / "good");
        } else {
            EXPECT_THROW(pipeline.rebuild(folder.path() / "broken"), KernelError);
        }
    }

    TemporaryFolder folder;
    Xvfb xvfb;
    mutable Window window{{.width = 32, .height = 20, .title = "long", .vsync = false}};
    Screen screen;
    Scene scene = load_scene(fs::path(STAGELIGHT_SOURCE_DIR) / "scenes" / "01_primitives.toml");
};

TEST_P(Stage07Endurance, LeavesMemoryAsItWas) {
    RenderSettings settings;
    settings.width = 32;
    settings.height = 20;
    FramePipeline pipeline(choose_device(implementations.front()), window.api(), "01_primitives",
                           scene, settings, {GetParam()}, TextureFormat::rgba32f);
    const auto bytes = pipeline.bytes();
    std::size_t resident_after_warming = 0;
    for (int frame = 0; frame < frames; ++frame) {
        show(pipeline);
        const int change = frame / frames_a_change;
        if (frame % frames_a_change == frames_a_change - 1) {
            finish_all(pipeline);
            pipeline.resize(change % 2 == 0 ? 48 + change % 7 : 32, change % 2 == 0 ? 31 : 20);
            reload(pipeline, change);
        }
        if (frame == frames / 5) {
            resident_after_warming = resident();
        }
    }
    finish_all(pipeline);
    EXPECT_EQ(pipeline.bytes(), bytes) << "at the size that it had at first";
    EXPECT_LE(textures_there_are(), 2) << "textures are made and not deleted";
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    const std::size_t now = resident();
    const std::size_t growth = now > resident_after_warming ? now - resident_after_warming : 0;
    std::cout << "grown by " << growth / 1024 << " KiB in " << frames * 4 / 5 << " frames\n";
    EXPECT_LT(growth, std::size_t{16} << 20);
}

INSTANTIATE_TEST_SUITE_P(Paths, Stage07Endurance,
                         testing::Values(DisplayPath::shared, DisplayPath::copy),
                         [](const auto &path) { return std::string(to_string(path.param)); });

}  // namespace
}  // namespace stagelight
