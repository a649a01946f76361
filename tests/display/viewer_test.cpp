// SPDX-License-Identifier: MIT
// The window as a person has it: what is pressed, dragged and resized, and what is shown then.
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cli/picture_file.h"
#include "device/device_choice.h"
#include "device/renderer.h"
#include "display/viewer.h"
#include "display/x_client.h"
#include "display/xvfb.h"
#include "image/image_io.h"
#include "implementations.h"
#include "scene/scene_file.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

constexpr auto stage = "01_primitives";

// The viewer looks at its own frames; a person presses keys beside it, and waits for what they
// do to show in the window's title or on disk.
class Stage07Viewer : public testing::Test {
protected:
    Stage07Viewer() {
        for (const char *part : {"kernels", "stages"}) {
            fs::copy(fs::path(STAGELIGHT_SOURCE_DIR) / part, folder.path() / part,
                     fs::copy_options::recursive);
        }
        settings.width = 64;
        settings.height = 40;
        view.checkout = folder.path();
        view.screenshots = folder.path() / "shot.exr";
    }

    // A person at the window, who can tell when what was done has been seen to: a screenshot that
    // is asked for then lies on disk. Twice, since a frame may have been started in between.
    class Person : public XClient {
    public:
        explicit Person(const fs::path &shots) : XClient("viewer"), shots_(shots) {
            while (fs::exists(shot(count_ + 1))) {
                ++count_;
            }
        }

        void tap(const std::string &key) {
            press(key);
            release(key);
        }
        // Until the title has that part, or half a minute has passed.
        void wait_for_title(const std::string &part) {
            for (int i = 0; i < 6000 && title().find(part) == std::string::npos; ++i) {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
        }
        void settle() {
            for (int i = 0; i < 2; ++i) {
                tap("p");
                wait_for(shot(++count_));
            }
        }

    private:
        fs::path shot(int index) const { return shots_ / fmt::format("shot_{}.exr", index); }
        static void wait_for(const fs::path &file) {
            for (int i = 0; i < 3000 && !fs::exists(file); ++i) {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
        }

        fs::path shots_;
        int count_ = 0;
    };

    // What the viewer has seen when `actions` are done and the window was left.
    ViewFigures run(const std::function<void(Person &)> &actions,
                    const std::function<void(Person &)> &leave = leave_by_escape) {
        FramePipeline pipeline(choose_device(implementations.front()), window.api(), stage, scene,
                               settings, {DisplayPath::copy}, TextureFormat::rgba32f);
        Viewer viewer(window, pipeline, stage, scene, view);
        Person person(folder.path());  // before the first frame gives the window another title
        std::jthread beside([&] {
            person.settle();
            actions(person);
            leave(person);
        });
        ViewFigures seen = viewer.run();
        last_settings = pipeline.settings();
        return seen;
    }

    static void leave_by_escape(Person &person) {
        person.settle();
        person.tap("Escape");
    }

    Image rendered(const CameraDescription &camera) const {
        Scene from_there = scene;
        from_there.camera = camera;
        return Renderer(choose_device(implementations.front()), stage, from_there, last_settings)
            .render()
            .image;
    }
    void replace_in_kernel(const std::string &text, const std::string &with) const {
        const fs::path file = folder.path() / "stages" / stage / "kernel.cl";
        std::ifstream in(file);
        std::string source{std::istreambuf_iterator<char>(in), {}};
        const std::size_t place = source.find(text);
        ASSERT_NE(place, std::string::npos);
        source.replace(place, text.size(), with);
        std::ofstream(file) << source;
    }

    TemporaryFolder folder;
    Xvfb xvfb;
    Window window{{.width = 64, .height = 40, .title = "viewer", .vsync = false}};
    Scene scene = load_scene(fs::path(STAGELIGHT_SOURCE_DIR) / "scenes" / "01_primitives.toml");
    RenderSettings settings;
    RenderSettings last_settings;
    ViewSettings view;
};

TEST_F(Stage07Viewer, RendersOnceWhileNothingChanges) {
    const ViewFigures seen = run([](Person &person) {
        person.expose();  // drawn anew, not rendered
    });
    EXPECT_EQ(seen.frames.size(), 1);
    EXPECT_EQ(seen.picture.pixels, rendered(scene.camera).pixels);
}

// One after the other, and no more than were asked for.
TEST_F(Stage07Viewer, AddsSamplesWhileNothingChanges) {
    settings.samples = 7;
    std::string title;
    const ViewFigures seen = run([&title](Person &person) {
        person.wait_for_title("  7/7 samples  ");
        person.expose();
        person.settle();
        title = person.title();
    });
    EXPECT_NE(title.find("  7/7 samples  "), std::string::npos) << title;
    EXPECT_EQ(seen.frames.size(), 1);
    EXPECT_EQ(seen.rays.primary, 7 * 64 * 40);
    EXPECT_EQ(seen.picture.pixels, rendered(scene.camera).pixels);
}

// Of a picture of another size, and of one by another kernel, no sample is an old one.
TEST_F(Stage07Viewer, BeginsWithTheFirstSampleWhenSomethingChanges) {
    settings.samples = 7;
    const ViewFigures resized = run([](Person &person) {
        person.wait_for_title("  7/7 samples  ");
        person.resize(50, 30);
        person.settle();
        person.wait_for_title("  7/7 samples  ");
    });
    EXPECT_EQ(resized.frames.size(), 2);
    EXPECT_EQ(resized.picture.width, 50);
    EXPECT_EQ(resized.picture.pixels, rendered(scene.camera).pixels);
}

TEST_F(Stage07Viewer, BeginsWithTheFirstSampleOfAReloadedKernel) {
    settings.samples = 7;
    replace_in_kernel("(0.5f + 0.5f * surface->normal) * (1.0f - darkening)", "(float3)(0.25f)");
    const ViewFigures seen = run([](Person &person) {
        person.wait_for_title("  7/7 samples  ");
        person.tap("r");
        person.settle();
        person.wait_for_title("  7/7 samples  ");
    });
    EXPECT_EQ(seen.frames.size(), 2);
    EXPECT_EQ(seen.picture.at(32, 20), glm::vec3(0.25F));
}

TEST_F(Stage07Viewer, AddsSamplesAgainWhenItHasFlown) {
    settings.samples = 7;
    std::string title;
    const ViewFigures seen = run([&title](Person &person) {
        person.wait_for_title("  7/7 samples  ");
        person.press("w");
        person.settle();
        person.release("w");
        person.settle();
        person.wait_for_title("  7/7 samples  ");
        title = person.title();
    });
    EXPECT_NE(title.find("  7/7 samples  "), std::string::npos) << title;
    EXPECT_GT(seen.frames.size(), 1);
    EXPECT_EQ(seen.rays.primary, 7 * 64 * 40) << "of the last picture";
}

TEST_F(Stage07Viewer, FliesWhileAKeyIsHeldAndShowsTheLastPlace) {
    const ViewFigures seen = run([](Person &person) {
        person.press("w");
        person.settle();
        person.release("w");
    });
    EXPECT_GT(seen.frames.size(), 3);
    EXPECT_NE(seen.picture.pixels, rendered(scene.camera).pixels);
}

TEST_F(Stage07Viewer, GivesThePictureTheWindowsNewSize) {
    view.scale = 2;
    const ViewFigures seen = run([](Person &person) { person.resize(201, 120); });
    EXPECT_EQ(seen.picture.width, 101);
    EXPECT_EQ(seen.picture.height, 60);
    EXPECT_EQ(seen.picture.pixels, rendered(scene.camera).pixels);
}

TEST_F(Stage07Viewer, ScreenshotsAreThePictureAndCountUp) {
    const ViewFigures seen = run([](Person &) {});
    for (int i = 1; i <= 4; ++i) {  // two each time that the person waits
        const cli::PictureFile shot =
            cli::read_picture_file(folder.path() / fmt::format("shot_{}.exr", i));
        EXPECT_EQ(shot.width, 64);
        EXPECT_EQ(shot.at(32, 20, 2), seen.picture.at(32, 20).b);
    }
}

TEST_F(Stage07Viewer, ScreenshotsOfEarlierRunsStay) {
    const fs::path earlier = folder.write("shot_1.exr", "an earlier picture");
    run([](Person &) {});
    EXPECT_EQ(fs::file_size(earlier), std::string("an earlier picture").size());
    EXPECT_TRUE(fs::exists(folder.path() / "shot_2.exr"));
}

TEST_F(Stage07Viewer, ReloadedKernelsDrawTheNextFrame) {
    replace_in_kernel("(0.5f + 0.5f * surface->normal) * (1.0f - darkening)", "(float3)(0.25f)");
    const ViewFigures seen = run([](Person &person) { person.tap("r"); });
    EXPECT_EQ(seen.frames.size(), 2);
    EXPECT_EQ(seen.picture.at(32, 20), glm::vec3(0.25F));
}

// The last kernel that was good goes on, and what is wrong with the new one is told.
TEST_F(Stage07Viewer, KernelsThatDoNotBuildAreToldAndLeftOut) {
    replace_in_kernel("const float line = ", "const float line = oops + ");
    testing::internal::CaptureStderr();
    const ViewFigures seen = run([](Person &person) {
        person.tap("r");
        person.settle();
        person.press("d");
        person.settle();
        person.release("d");
    });
    const std::string told = testing::internal::GetCapturedStderr();
    EXPECT_NE(told.find("stages/01_primitives/kernel.cl"), std::string::npos) << told;
    EXPECT_NE(told.find("oops"), std::string::npos) << told;
    EXPECT_GT(seen.frames.size(), 2);
    EXPECT_GT(seen.picture.at(32, 20).b, 0) << "the old kernel no longer draws";
}

// Of a kernel that was never the viewer's: a file that is gone.
TEST_F(Stage07Viewer, MissingKernelsAreToldAndLeftOut) {
    fs::remove(folder.path() / "kernels" / "sphere.cl");
    testing::internal::CaptureStderr();
    const ViewFigures seen = run([](Person &person) { person.tap("r"); });
    EXPECT_NE(testing::internal::GetCapturedStderr().find("kernels/sphere.cl"), std::string::npos);
    EXPECT_EQ(seen.frames.size(), 1);
}

TEST_F(Stage07Viewer, TheTitleSaysWhatAFrameCosts) {
    std::string title;
    run([&title](Person &person) { title = person.title(); });
    const std::string device = choose_device(implementations.front()).getInfo<CL_DEVICE_NAME>();
    for (const char *part : {"01_primitives", " ms", " million rays/s", "copy", device.c_str()}) {
        EXPECT_NE(title.find(part), std::string::npos) << part << " in " << title;
    }
}

// Closed while frames are in flight: they end, and nothing crashes.
TEST_F(Stage07Viewer, ClosesWhileAFrameIsInFlight) {
    view.frames = 1000000;
    const ViewFigures seen = run([](Person &) {}, [](Person &person) { person.click_close(); });
    EXPECT_GT(seen.frames.size(), 1);
    EXPECT_LT(seen.frames.size(), 1000000);
}

// Nothing is rendered for a window that nobody can see.
TEST_F(Stage07Viewer, RestsWhileMinimised) {
    const ViewFigures seen = run([](Person &person) {
        person.minimise();
        person.restore();
    });
    EXPECT_LE(seen.frames.size(), 2);
    EXPECT_EQ(seen.picture.width, 64);
}

}  // namespace
}  // namespace stagelight
