// SPDX-License-Identifier: MIT
#include "display/viewer.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "image/image_io.h"
#include "image/split.h"
#include "scene/errors.h"

namespace stagelight {
namespace {

constexpr double title_period = 250;  // milliseconds

// A guess at the way across what is seen: the camera looks at the middle of it.
double size_of(const CameraDescription &camera) {
    return 2 * glm::distance(camera.position, camera.look_at);
}

}  // namespace

Viewer::Viewer(Window &window, FramePipeline &pipeline, const std::string &stage,
               const Scene &scene, const ViewSettings &view)
    : window_(window), pipeline_(pipeline), stage_(stage), view_(view),
      camera_(scene.camera, size_of(scene.camera)), framebuffer_(window.framebuffer_size()),
      last_input_(now_milliseconds()) {}

bool Viewer::done() const {
    return window_.closed()
           || (view_.frames && figures_.frames.size() >= std::size_t(*view_.frames)
               && shown_ == pipeline_.settings().samples);
}

bool Viewer::wants_frame() const {
    if (view_.frames) {
        const auto in_flight = std::ranges::count(started_, true, &Started::begins);
        return pipeline_.started() % pipeline_.settings().samples != 0
               || figures_.frames.size() + std::size_t(in_flight) < std::size_t(*view_.frames);
    }
    return !pipeline_.complete(camera_.camera()) && framebuffer_.x > 0;
}

// #region loop
ViewFigures Viewer::run() {
    while (!done()) {
        handle(next_input());
        fit_to_window();
        if (wants_frame()) {
            start_frame();
        }
        // While the frame that was just started is rendered, the one before is shown.
        if (!pipeline_.empty() && (pipeline_.full() || !wants_frame())) {
            finish_frame();
        } else if (redraw_) {
            draw();
        }
    }
    finish_all();
    figures_.picture = pipeline_.texture().read();
    return std::move(figures_);
}
// #endregion loop

// Sleeps while there is nothing to do.
Input Viewer::next_input() {
    const bool idle = !wants_frame() && pipeline_.empty() && !redraw_;
    return idle ? window_.wait(1) : window_.poll();
}

void Viewer::handle(const Input &input) {
    const double now = now_milliseconds();
    camera_.update(input, (now - last_input_) / 1000);
    last_input_ = now;
    redraw_ |= input.needs_redraw || input.resized;
    if (input.help) {
        help_ = !help_;
        redraw_ = true;
    }
    if (input.reload) {
        reload();
    }
    if (input.screenshot) {
        take_screenshot();
    }
    if (!input.trouble.empty()) {
        fmt::print(stderr, "window: {}\n", input.trouble);
    }
}

// The picture keeps the size that was asked for until the window is given another.
void Viewer::fit_to_window() {
    const glm::ivec2 size = window_.framebuffer_size();
    if (size == framebuffer_) {
        return;
    }
    framebuffer_ = size;
    if (size.x > 0 && size.y > 0) {
        finish_all();
        const auto pixels = [&](int length) {
            return std::max(1, static_cast<int>(std::lround(length / view_.scale)));
        };
        pipeline_.resize(pixels(size.x), pixels(size.y));
    }
}

void Viewer::start_frame() {
    const double at = now_milliseconds();
    pipeline_.start(camera_.camera());
    started_.push_back({at, pipeline_.started() == 1});
    while (started_.size() > pipeline_.in_flight()) {
        started_.pop_front();  // lost with its presenter
    }
}

void Viewer::finish_frame() {
    const double asked = now_milliseconds();
    const std::optional<FinishedFrame> frame = pipeline_.finish();
    if (!frame) {  // lost with its presenter
        started_.clear();
        return;
    }
    FrameTimes times;
    times.render = frame->render;
    times.present.begin = std::max(frame->render.end, asked);
    draw();
    times.present.end = now_milliseconds();
    const double before = figures_.frames.empty() ? 0 : figures_.frames.back().present.end;
    times.milliseconds = times.present.end - std::max(started_.front().at, before);
    started_.pop_front();
    if (figures_.frames.empty()) {
        figures_.first_shown = times.present.end;
    }
    keep(times, *frame);
    update_title(times.milliseconds, *frame);
}

// All of a run that is counted; of one that is not, the latest: it may go on for hours.
void Viewer::keep(const FrameTimes &times, const FinishedFrame &sample) {
    constexpr std::size_t most = 1000;
    shown_ = sample.sample + 1;
    if (sample.sample > 0) {
        FrameTimes &picture = figures_.frames.back();
        picture.render.end = times.render.end;
        picture.present = times.present;
        picture.milliseconds += times.milliseconds;
        figures_.rays += sample.rays;
        return;
    }
    figures_.rays = sample.rays;
    if (!view_.frames && figures_.frames.size() == most) {
        figures_.frames.erase(figures_.frames.begin());
    }
    figures_.frames.push_back(times);
}

void Viewer::finish_all() {
    while (!pipeline_.empty()) {
        finish_frame();
    }
}

void Viewer::draw() {
    redraw_ = false;
    if (framebuffer_.x == 0) {
        return;
    }
    screen_.draw(pipeline_.texture().id(), framebuffer_, window_.color_bits(), view_.encode,
                 view_.split ? std::optional(split_share) : std::nullopt);
    const std::vector<std::string> &lines = help_ ? key_help() : build_log_;
    if (!lines.empty()) {
        overlay_.draw(lines, framebuffer_, window_.content_scale());
    }
    window_.swap();
}

void Viewer::reload() {
    finish_all();
    build_log_.clear();
    try {
        pipeline_.rebuild(view_.checkout);
        fmt::print("kernels reloaded from {}\n", view_.checkout.string());
    } catch (const KernelError &error) {
        keep_build_log(error.what());
    } catch (const UserError &error) {  // a file is missing
        keep_build_log(error.what());
    }
    redraw_ = true;
}

void Viewer::keep_build_log(const std::string &log) {
    fmt::print(stderr, "{}\n", log);
    help_ = false;  // the log is what there is to read now
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        build_log_.push_back(line);
    }
}

void Viewer::take_screenshot() {
    finish_all();
    std::filesystem::path file;
    do {  // those of earlier runs stay
        file = view_.screenshots;
        file.replace_filename(fmt::format("{}_{}{}", file.stem().string(), ++screenshots_,
                                          file.extension().string()));
    } while (exists(file));
    std::error_code ignored;  // what is wrong with the folder is told by write_image
    std::filesystem::create_directories(file.parent_path(), ignored);
    try {
        write_image(pipeline_.texture().read(), file, view_.encode, view_.split);
        fmt::print("wrote {}\n", file.string());
    } catch (const UserError &error) {
        fmt::print(stderr, "{}\n", error.what());
    }
}

void Viewer::update_title(double milliseconds, const FinishedFrame &sample) {
    const double now = now_milliseconds();
    const int samples = pipeline_.settings().samples;
    const bool rests = samples > 1 && shown_ == samples;
    if (now - last_title_ < title_period && rests == title_rests_) {
        return;
    }
    title_rests_ = rests;
    last_title_ = now;
    const std::string progress = samples > 1 ? fmt::format("  {}/{} samples", shown_, samples) : "";
    window_.set_title(fmt::format("{}  {:.1f} ms{}  {:.1f} million rays/s  {}  {}", stage_,
                                  milliseconds, progress, sample.rays.rate(sample.render.length()),
                                  to_string(pipeline_.path()),
                                  pipeline_.device().getInfo<CL_DEVICE_NAME>()));
}

}  // namespace stagelight
