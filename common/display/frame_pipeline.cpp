// SPDX-License-Identifier: MIT
#include "display/frame_pipeline.h"

#include <fmt/format.h>

#include "device/device_types.h"
#include "display/copy_presenter.h"
#include "display/shared_presenter.h"
#include "scene/progress.h"

namespace stagelight {
namespace {

const char *reason_for(DisplayPath path) {
    return path == DisplayPath::shared ? "OpenCL renders into the window's texture"
                                       : "the picture is copied into the window's texture";
}

}  // namespace

const char *to_string(DisplayPath path) {
    return path == DisplayPath::shared ? "shared" : "copy";
}

FramePipeline::FramePipeline(const cl::Device &device, ContextApi api, const std::string &stage,
                             const Scene &scene, const RenderSettings &settings,
                             const std::deque<DisplayPath> &chain, TextureFormat format)
    : device_(device), api_(api), stage_(stage), scene_(scene), settings_(settings),
      fallbacks_(chain), format_(format) {
    take_next();
}

std::unique_ptr<Presenter> FramePipeline::make_presenter(DisplayPath path) const {
    if (path == DisplayPath::shared) {
        return std::make_unique<SharedPresenter>(device_, api_, format_);
    }
    return std::make_unique<CopyPresenter>(device_, format_);
}

StageKernel FramePipeline::build(const RenderSettings &settings) const {
    return {presenter_->context(), device_, stage_, scene_, settings, presenter_->picture()};
}

void FramePipeline::take(DisplayPath path) {
    kernel_.reset();
    presenter_.reset();
    in_flight_ = 0;
    started_ = 0;
    path_ = path;
    presenter_ = make_presenter(path);
    presenter_->resize(settings_.width, settings_.height);
    kernel_ = build(settings_);
    report(fmt::format("{}: {}", to_string(path), reason_for(path)));
}

void FramePipeline::report(const std::string &line) {
    say("display: " + line);
    reason_ += (reason_.empty() ? "" : "; ") + line;
}

void FramePipeline::take_next() {
    if (fallbacks_.empty()) {
        throw PresenterLost(reason_);
    }
    const DisplayPath path = fallbacks_.front();
    fallbacks_.pop_front();
    attempt([&] { take(path); });
}

// False where the presenter failed, and the next one was taken.
bool FramePipeline::attempt(const std::function<void()> &action) {
    std::string reason;
    try {
        action();
        return true;
    } catch (const PresenterLost &lost) {
        reason = lost.what();
    } catch (const cl::Error &error) {
        reason = fmt::format("{} failed with error {}", error.what(), error.err());
    }
    report(fmt::format("no {}: {}", to_string(path_), reason));
    take_next();
    return false;
}

void FramePipeline::resize(int width, int height) {
    settings_.width = width;
    settings_.height = height;
    started_ = 0;
    attempt([&] { presenter_->resize(width, height); });
}

void FramePipeline::rebuild(const std::optional<std::filesystem::path> &kernels) {
    RenderSettings settings = settings_;
    settings.kernels = kernels;
    kernel_ = build(settings);
    settings_ = settings;
    started_ = 0;
}

void FramePipeline::start(const CameraDescription &camera) {
    if (started_ == settings_.samples || !(camera == camera_)) {
        started_ = 0;
    }
    camera_ = camera;
    device::DoubleCamera view = to_device(camera, settings_.width, settings_.height);
    view.media = kernel_->media().at(scene_, camera.position);
    while (
        !attempt([&] { presenter_->start(*kernel_, view, started_); })) {  // the next begins anew
    }
    ++started_;
    ++in_flight_;
}

std::optional<FinishedFrame> FramePipeline::finish() {
    std::optional<FinishedFrame> frame;
    if (attempt([&] { frame = presenter_->finish(); })) {
        --in_flight_;
    }
    return frame;
}

std::map<std::string, std::size_t> FramePipeline::bytes() const {
    std::map<std::string, std::size_t> bytes = kernel_->bytes();
    bytes["image"] = presenter_->bytes();
    return bytes;
}

}  // namespace stagelight
