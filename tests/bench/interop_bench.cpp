// SPDX-License-Identifier: MIT
// ./stagelight bench interop: what it costs to bring a picture to the window, on each
// display path, and in the way that the paper started from (section 2).
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/run_main.h"
#include "bench/collected_runs.h"
#include "device/device_choice.h"
#include "device/renderer.h"
#include "display/gl_sharing.h"
#include "display/viewer.h"
#include "scene/errors.h"
#include "scene/progress.h"
#include "scene/scene_file.h"

namespace stagelight {
namespace {

constexpr int frames_a_run = 20;
constexpr int repetitions = 5;

struct Work {
    std::string stage;
    Scene scene;
    RenderSettings settings;
};

Work work_of(const std::string &stage) {
    Work work{
        stage,
        load_scene(std::filesystem::path(STAGELIGHT_SOURCE_DIR) / "scenes" / (stage + ".toml")),
        {}};
    work.settings.width = work.scene.width;
    work.settings.height = work.scene.height;
    work.settings.max_depth = work.scene.max_depth;
    return work;
}

WindowSettings window_of(const Work &work) {
    return {.width = work.settings.width,
            .height = work.settings.height,
            .title = work.stage,
            .api = ContextApi::native,
            .vsync = false};
}

cl::Device device_for(const Window &window) {
    return devices_to_share("", window.api()).front();
}

// The first frame waits for what the drivers put off until they are used.
std::vector<FrameTimes> without_first(const std::vector<FrameTimes> &frames) {
    return {frames.end() - frames_a_run, frames.end()};
}

std::vector<FrameTimes> show_on(DisplayPath path, const Work &work) {
    Window window(window_of(work));
    FramePipeline pipeline(device_for(window), window.api(), work.stage, work.scene, work.settings,
                           {path}, TextureFormat::rgba32f);
    ViewSettings view;
    view.frames = frames_a_run + 1;
    return without_first(Viewer(window, pipeline, work.stage, work.scene, view).run().frames);
}

// #region naive
// 8 bits a channel, for a texture that is made for this frame alone.
GLuint new_texture(const Image &image) {
    std::vector<unsigned char> bytes;
    bytes.reserve(4 * image.pixels.size());
    const auto to_byte = [](float value) {
        return static_cast<unsigned char>(std::lround(255 * encode(Transfer::none, value)));
    };
    for (const glm::vec3 &pixel : image.pixels) {
        bytes.insert(bytes.end(), {to_byte(pixel.r), to_byte(pixel.g), to_byte(pixel.b), 255});
    }
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, bytes.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

// The picture is read back, converted on the CPU, and uploaded, one after the other.
std::vector<FrameTimes> show_naively(const Work &work) {
    Window window(window_of(work));
    Renderer renderer(device_for(window), work.stage, work.scene, work.settings);
    const Screen screen;
    std::vector<FrameTimes> frames;
    for (int i = 0; i <= frames_a_run; ++i) {
        window.poll();
        const double start = now_milliseconds();
        const Frame frame = renderer.render();
        const GLuint texture = new_texture(frame.image);
        screen.draw(texture, window.framebuffer_size(), window.color_bits(), Transfer::none);
        window.swap();
        glDeleteTextures(1, &texture);
        const double end = now_milliseconds();
        const double rendered = start + frame.milliseconds;
        frames.push_back({{start, rendered}, {rendered, end}, end - start});
    }
    return without_first(frames);
}
// #endregion naive

template <typename Show> void measure(benchmark::State &state, const Show &show) {
    std::vector<FrameTimes> frames;
    for (auto _ : state) {
        try {
            frames = show();
        } catch (const PresenterLost &lost) {
            state.SetLabel(lost.what());  // the field of the next one has had two names
            state.SkipWithError(lost.what());
            return;
        }
        state.SetIterationTime(median_of(frames, [](auto f) { return f.milliseconds; }) / 1000);
    }
    state.counters["render"] = median_of(frames, [](auto f) { return f.render.length(); });
    state.counters["present"] = median_of(frames, [](auto f) { return f.present.length(); });
    state.counters["overlap"] = overlap_of(frames);
}

// One line a way: the medians of all its repetitions.
class Table : public bench::CollectedRuns {
public:
    // The cost is what a frame takes beside its rendering alone, which is that of the naive way:
    // nothing else runs then.
    void Finalize() override {
        say(fmt::format("\n{:<22} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9}", "milliseconds", "a frame",
                        "render", "present", "overlap", "cost", "frames/s"));
        for (const auto &[name, runs] : this->runs()) {
            if (const std::string &lost = runs.front().report_label; !lost.empty()) {
                say(fmt::format("{:<22} not here: {}", name, lost));
                continue;
            }
            const double whole =
                median_of(runs, [](const Run &run) { return run.GetAdjustedRealTime(); });
            say(fmt::format("{:<22} {:8.2f} {:8.2f} {:8.2f} {:7.0f}% {:7.0f}% {:9.1f}", name, whole,
                            counter(runs, "render"), counter(runs, "present"),
                            100 * counter(runs, "overlap"), 100 * (1 - render_alone(name) / whole),
                            1000 / whole));
        }
    }

private:
    double render_alone(const std::string &name) const {
        const auto naive = runs().find(name.substr(0, name.find('/')) + "/naive");
        return naive == runs().end() ? std::nan("") : counter(naive->second, "render");
    }
};

void register_all(const Work &work, Progress &progress) {
    const auto add = [&](const std::string &way, const auto &show) {
        benchmark::RegisterBenchmark((work.stage + "/" + way).c_str(),
                                     [&work, &progress, show](benchmark::State &state) {
                                         measure(state, [&] { return show(work); });
                                         progress.step();
                                     })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1)
            ->Repetitions(repetitions);
    };
    add("shared", [](const Work &w) { return show_on(DisplayPath::shared, w); });
    add("copy", [](const Work &w) { return show_on(DisplayPath::copy, w); });
    add("naive", [](const Work &w) { return show_naively(w); });
}

int bench_interop(int argc, char **argv) {
    const std::vector<Work> works{work_of("01_primitives"), work_of("07_interop")};
    Progress progress("measuring", 3 * repetitions * works.size());
    for (const Work &work : works) {
        register_all(work, progress);
    }
    {
        const Window window(window_of(works.front()));
        say(fmt::format("OpenCL: {}\nOpenGL: {}", device_for(window).getInfo<CL_DEVICE_NAME>(),
                        reinterpret_cast<const char *>(glGetString(GL_RENDERER))));
    }
    Table table;
    return bench::run_benchmarks(argc, argv, table);
}

}  // namespace
}  // namespace stagelight

int main(int argc, char **argv) {
    return stagelight::run_main([&] { return stagelight::bench_interop(argc, argv); });
}
