// SPDX-License-Identifier: MIT
// Frames on their way from a stage's kernel to the window's texture, on the first
// display path that works.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "display/presenter.h"
#include "display/window.h"

namespace stagelight {

enum class DisplayPath { shared, copy };

const char *to_string(DisplayPath path);

class FramePipeline {
public:
    // `chain` is what may be tried, best first; `api` that of the current OpenGL context. Says on
    // stdout which path works, and of each that does not, why. Throws PresenterLost when none does,
    // and as StageKernel does.
    FramePipeline(const cl::Device &device, ContextApi api, const std::string &stage,
                  const Scene &scene, const RenderSettings &settings,
                  const std::deque<DisplayPath> &chain, TextureFormat format);

    // The picture's size in pixels. No frame is in flight.
    void resize(int width, int height);
    // Builds the kernel anew. Where that throws, the old one stays. No frame is in flight.
    void rebuild(const std::optional<std::filesystem::path> &kernels);

    // Sets the next sample of what that camera sees going: the first one where the camera, the size
    // or the kernel is another than before, and where all were started. A path that fails here is
    // left for the next one; what was in flight on it is lost. Throws PresenterLost when there is
    // none.
    void start(const CameraDescription &camera);
    // Whether all samples of what that camera sees were started.
    bool complete(const CameraDescription &camera) const {
        return started_ == settings_.samples && camera == camera_;
    }
    // How many were, of what the last camera sees.
    int started() const { return started_; }
    // The frame that was started first is in texture(), unless it was lost.
    std::optional<FinishedFrame> finish();

    bool empty() const { return in_flight_ == 0; }
    bool full() const { return in_flight_ == presenter_->most_in_flight(); }
    std::size_t in_flight() const { return in_flight_; }

    DisplayPath path() const { return path_; }
    // What was said of the paths: why this one, and why none before it.
    const std::string &reason() const { return reason_; }
    const cl::Device &device() const { return device_; }
    const FloatTexture &texture() const { return presenter_->texture(); }
    const StageKernel &stage_kernel() const { return *kernel_; }
    const RenderSettings &settings() const { return settings_; }
    std::map<std::string, std::size_t> bytes() const;

private:
    std::unique_ptr<Presenter> make_presenter(DisplayPath path) const;
    StageKernel build(const RenderSettings &settings) const;
    void take(DisplayPath path);
    void take_next();
    void report(const std::string &line);
    bool attempt(const std::function<void()> &action);

    cl::Device device_;
    ContextApi api_;
    std::string stage_;
    const Scene &scene_;
    RenderSettings settings_;
    std::deque<DisplayPath> fallbacks_;  // what is left to try
    TextureFormat format_;
    DisplayPath path_ = DisplayPath::copy;
    std::string reason_;
    std::unique_ptr<Presenter> presenter_;
    std::optional<StageKernel> kernel_;
    std::size_t in_flight_ = 0;
    CameraDescription camera_;
    int started_ = 0;  // samples of what it sees
};

}  // namespace stagelight
