// SPDX-License-Identifier: MIT
// The presenters of the display paths, with the layer that gives every device cl_khr_gl_sharing:
// what the window shows is, bit for bit, what is rendered without one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "device/device_choice.h"
#include "device/renderer.h"
#include "display/layer_loaded.h"
#include "display/viewer.h"
#include "display/xvfb.h"
#include "implementations.h"
#include "scene/scene_file.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

Scene scene_of(const std::string &stage) {
    return load_scene(std::filesystem::path(STAGELIGHT_SOURCE_DIR) / "scenes" / (stage + ".toml"));
}

// Of no size that a work-group divides.
RenderSettings small_settings(const Scene &scene) {
    RenderSettings settings;
    settings.width = 61;
    settings.height = 37;
    settings.max_depth = scene.max_depth;
    return settings;
}

WindowSettings window_settings(ContextApi api = ContextApi::native) {
    return {.width = 61, .height = 37, .title = "test", .api = api, .vsync = false};
}

Image without_window(const std::string &device, const std::string &stage, const Scene &scene) {
    return Renderer(choose_device(device), stage, scene, small_settings(scene)).render().image;
}

void expect_same(const Image &shown, const Image &rendered) {
    ASSERT_EQ(shown.width, rendered.width);
    ASSERT_EQ(shown.height, rendered.height);
    int different = 0;
    for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
        different += shown.pixels[i] != rendered.pixels[i];
    }
    EXPECT_EQ(different, 0) << "of " << shown.pixels.size() << " pixels";
}

class WithDisplay : public testing::Test {
    Xvfb xvfb_;
};

using Case = std::tuple<const char *, DisplayPath, ContextApi>;

class Stage07Presenters : public testing::TestWithParam<Case> {
    Xvfb xvfb_;
};

TEST_P(Stage07Presenters, ShowWhatIsRenderedWithoutAWindow) {
    const auto &[device, path, api] = GetParam();
    const Scene scene = scene_of("07_interop");
    Window window(window_settings(api));
    FramePipeline pipeline(choose_device(device), window.api(), "07_interop", scene,
                           small_settings(scene), {path}, TextureFormat::rgba32f);
    EXPECT_EQ(pipeline.path(), path);
    ViewSettings view;
    view.frames = 60;
    const ViewFigures seen = Viewer(window, pipeline, "07_interop", scene, view).run();
    EXPECT_EQ(seen.frames.size(), 60);
    expect_same(seen.picture, without_window(device, "07_interop", scene));
}

// A mean of seven, which no power of two divides: the same sum in the same order, and the same
// division.
TEST_P(Stage07Presenters, AddSamplesToWhatIsRenderedWithoutAWindow) {
    const auto &[device, path, api] = GetParam();
    const Scene scene = scene_of("07_interop");
    RenderSettings settings = small_settings(scene);
    settings.samples = 7;
    const Image exact =
        Renderer(choose_device(device), "07_interop", scene, settings).render().image;
    Window window(window_settings(api));
    FramePipeline pipeline(choose_device(device), window.api(), "07_interop", scene, settings,
                           {path}, TextureFormat::rgba32f);
    ViewSettings view;
    view.frames = 3;
    const ViewFigures seen = Viewer(window, pipeline, "07_interop", scene, view).run();
    EXPECT_EQ(pipeline.path(), path);
    EXPECT_EQ(seen.frames.size(), 3) << "a frame has all of its samples";
    EXPECT_EQ(seen.rays.primary, 7 * 61 * 37);
    expect_same(seen.picture, exact);
}

std::string name_of(const testing::TestParamInfo<Case> &instance) {
    const auto &[device, path, api] = instance.param;
    return fmt::format("{}_{}_{}", name_in_tests(device), to_string(path),
                       api == ContextApi::egl ? "egl" : "glx");
}

INSTANTIATE_TEST_SUITE_P(All, Stage07Presenters,
                         testing::Combine(testing::ValuesIn(implementations),
                                          testing::Values(DisplayPath::shared, DisplayPath::copy),
                                          testing::Values(ContextApi::native, ContextApi::egl)),
                         name_of);

class Stage07EveryStage : public testing::TestWithParam<std::string> {
    Xvfb xvfb_;
};

// Each stage's kernel can write to an image as to a buffer.
TEST_P(Stage07EveryStage, IsShownOnSharedAsWithoutAWindow) {
    const std::string &stage = GetParam();
    const Scene scene = scene_of(stage);
    Window window(window_settings());
    FramePipeline pipeline(choose_device(implementations.front()), window.api(), stage, scene,
                           small_settings(scene), {DisplayPath::shared}, TextureFormat::rgba32f);
    pipeline.start(scene.camera);
    ASSERT_TRUE(pipeline.finish());
    expect_same(pipeline.texture().read(), without_window(implementations.front(), stage, scene));
}

INSTANTIATE_TEST_SUITE_P(All, Stage07EveryStage, testing::ValuesIn(stage_names()),
                         [](const auto &instance) { return instance.param; });

class Stage07FallbackChain : public WithDisplay {
protected:
    Scene scene = scene_of("01_primitives");
    Window window{window_settings()};

    FramePipeline pipeline(const std::deque<DisplayPath> &chain,
                           TextureFormat format = TextureFormat::rgba32f) const {
        return {choose_device(implementations.front()),
                window.api(),
                "01_primitives",
                scene,
                small_settings(scene),
                chain,
                format};
    }
    Image rendered() const {
        return without_window(implementations.front(), "01_primitives", scene);
    }
};

// A texture in half precision holds 11 bits of the picture, rounded or, as Mesa does, cut off.
TEST_F(Stage07FallbackChain, HalfPrecisionIsTheUsersChoice) {
    for (const DisplayPath path : {DisplayPath::shared, DisplayPath::copy}) {
        FramePipeline half = pipeline({path}, TextureFormat::rgba16f);
        half.start(scene.camera);
        half.finish();
        const Image shown = half.texture().read();
        const Image exact = rendered();
        int rounded = 0;
        for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
            EXPECT_NEAR(shown.pixels[i].g, exact.pixels[i].g, 0.00098F * exact.pixels[i].g);
            rounded += shown.pixels[i].g != exact.pixels[i].g;
        }
        EXPECT_GT(rounded, 1000) << to_string(path) << ": was that full precision?";
    }
}

// What OpenCL can't use any more is left for the next path, in the middle of a run.
TEST_F(Stage07FallbackChain, AnyThatIsLostGivesWayToTheNext) {
    FramePipeline both = pipeline({DisplayPath::shared, DisplayPath::copy});
    both.start(scene.camera);
    ASSERT_TRUE(both.finish());
    EXPECT_EQ(both.path(), DisplayPath::shared);
    const GLuint texture = both.texture().id();
    glDeleteTextures(1, &texture);
    both.start(scene.camera);
    EXPECT_EQ(both.path(), DisplayPath::copy);
    EXPECT_NE(both.reason().find("no shared: "), std::string::npos) << both.reason();
    ASSERT_TRUE(both.finish());
    expect_same(both.texture().read(), rendered());
}

// OpenCL is asked to share with a context that is not the current one's.
TEST_F(Stage07FallbackChain, AContextThatOpenClCannotShareWithGivesWay) {
    const ContextApi other = window.api() == ContextApi::egl ? ContextApi::native : ContextApi::egl;
    const FramePipeline copied(choose_device(implementations.front()), other, "01_primitives",
                               scene, small_settings(scene),
                               {DisplayPath::shared, DisplayPath::copy}, TextureFormat::rgba32f);
    EXPECT_EQ(copied.path(), DisplayPath::copy);
    EXPECT_NE(copied.reason().find("no shared: clGetGLContextInfoKHR failed with error -1000"),
              std::string::npos)
        << copied.reason();
}

TEST_F(Stage07FallbackChain, TexturesThatAreTooLargeGiveWay) {
    FramePipeline one = pipeline({DisplayPath::copy});
    EXPECT_THROW(one.resize(100000, 1), PresenterLost);
}

TEST_F(Stage07FallbackChain, EndsWhenNoneIsLeft) {
    FramePipeline one = pipeline({DisplayPath::shared});
    const GLuint texture = one.texture().id();
    glDeleteTextures(1, &texture);
    EXPECT_THROW(one.start(scene.camera), PresenterLost);
}

// The picture follows the window's size.
TEST_F(Stage07FallbackChain, ResizedPicturesAreThoseOfTheirSize) {
    for (const DisplayPath path : {DisplayPath::shared, DisplayPath::copy}) {
        FramePipeline resized = pipeline({path});
        for (const auto &[width, height] : {std::pair{17, 5}, {64, 64}, {1, 1}, {61, 37}}) {
            resized.resize(width, height);
            resized.start(scene.camera);
            ASSERT_TRUE(resized.finish());
            RenderSettings settings = small_settings(scene);
            settings.width = width;
            settings.height = height;
            expect_same(resized.texture().read(), Renderer(choose_device(implementations.front()),
                                                           "01_primitives", scene, settings)
                                                      .render()
                                                      .image);
        }
    }
}

// A camera that moves on, and a path that is lost, leave nothing of the samples before.
TEST_F(Stage07FallbackChain, AnotherViewBeginsWithItsFirstSample) {
    RenderSettings settings = small_settings(scene);
    settings.samples = 5;
    FramePipeline both(choose_device(implementations.front()), window.api(), "01_primitives", scene,
                       settings, {DisplayPath::shared, DisplayPath::copy}, TextureFormat::rgba32f);
    CameraDescription other = scene.camera;
    other.position.y += 0.5;
    const auto add = [&both](const CameraDescription &camera, int samples) {
        for (int i = 0; i < samples; ++i) {
            both.start(camera);
            EXPECT_TRUE(both.finish());
        }
    };
    const Image exact =
        Renderer(choose_device(implementations.front()), "01_primitives", scene, settings)
            .render()
            .image;
    add(other, 3);
    add(scene.camera, 5);
    EXPECT_TRUE(both.complete(scene.camera));
    EXPECT_FALSE(both.complete(other));
    expect_same(both.texture().read(), exact);
    add(scene.camera, 2);
    const GLuint texture = both.texture().id();
    glDeleteTextures(1, &texture);
    add(scene.camera, 1);
    EXPECT_EQ(both.path(), DisplayPath::copy);
    EXPECT_EQ(both.started(), 1);
    add(scene.camera, 4);
    expect_same(both.texture().read(), exact);
}

// Two frames at once, of two cameras: each comes out as its own.
TEST_F(Stage07FallbackChain, CopiesTwoFramesAtATimeInTheirOrder) {
    FramePipeline copy = pipeline({DisplayPath::copy});
    CameraDescription other = scene.camera;
    other.position.y += 0.5;
    const Image first = rendered();
    for (int round = 0; round < 3; ++round) {
        copy.start(scene.camera);
        copy.start(other);
        EXPECT_TRUE(copy.full());
        ASSERT_TRUE(copy.finish());
        expect_same(copy.texture().read(), first);
        ASSERT_TRUE(copy.finish());
        EXPECT_NE(copy.texture().read().pixels, first.pixels);
        EXPECT_TRUE(copy.empty());
    }
}

}  // namespace
}  // namespace stagelight
