// SPDX-License-Identifier: MIT
// Frames on their way from a stage's kernel to the window's texture, on the highest rung of the
// ladder that holds.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "display/rung.h"
#include "display/window.h"

namespace stagelight {

enum class RungName { shared, copy };

const char *to_string(RungName name);

class FramePipeline {
public:
    // `ladder` is what may be tried, best first; `api` that of the current OpenGL context. Says on
    // stdout which rung holds, and of each that does not, why. Throws RungLost when none does, and
    // as StageKernel does.
    FramePipeline(const cl::Device &device, ContextApi api, const std::string &stage,
                  const Scene &scene, const RenderSettings &settings,
                  const std::deque<RungName> &ladder, TextureFormat format);

    // The picture's size in pixels. No frame is in flight.
    void resize(int width, int height);
    // Builds the kernel anew. Where that throws, the old one stays. No frame is in flight.
    void rebuild(const std::optional<std::filesystem::path> &kernels);

    // Sets the next sample of what that camera sees going: the first one where the camera, the size
    // or the kernel is another than before, and where all were started. A rung that fails here is
    // left for the next one; what was in flight on it is lost. Throws RungLost when there is none.
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
    bool full() const { return in_flight_ == rung_->most_in_flight(); }
    std::size_t in_flight() const { return in_flight_; }

    RungName rung() const { return name_; }
    // What was said of the ladder: why this rung, and why none above it.
    const std::string &reason() const { return reason_; }
    const cl::Device &device() const { return device_; }
    const FloatTexture &texture() const { return rung_->texture(); }
    const StageKernel &stage_kernel() const { return *kernel_; }
    const RenderSettings &settings() const { return settings_; }
    std::map<std::string, std::size_t> bytes() const;

private:
    std::unique_ptr<Rung> make_rung(RungName name) const;
    StageKernel build(const RenderSettings &settings) const;
    void take(RungName name);
    void take_next();
    void report(const std::string &line);
    bool attempt(const std::function<void()> &action);

    cl::Device device_;
    ContextApi api_;
    std::string stage_;
    const Scene &scene_;
    RenderSettings settings_;
    std::deque<RungName> ladder_;  // what is left to try
    TextureFormat format_;
    RungName name_ = RungName::copy;
    std::string reason_;
    std::unique_ptr<Rung> rung_;
    std::optional<StageKernel> kernel_;
    std::size_t in_flight_ = 0;
    CameraDescription camera_;
    int started_ = 0;  // samples of what it sees
};

}  // namespace stagelight
