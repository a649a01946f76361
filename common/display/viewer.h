// SPDX-License-Identifier: MIT
// The window's loop: what is pressed, rendered and shown.
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "display/fly_camera.h"
#include "display/frame_pipeline.h"
#include "display/overlay.h"
#include "display/screen.h"
#include "display/window.h"
#include "image/transfer.h"

namespace stagelight {

struct ViewSettings {
    double scale = 1;           // the window's pixels for one of the picture's, each way
    std::optional<int> frames;  // then the window closes; else the user closes it
    Transfer encode = Transfer::none;
    bool split = false;                 // right of the middle nothing is encoded
    std::filesystem::path screenshots;  // "out/a.png": P writes out/a_1.png, out/a_2.png, …
    std::filesystem::path checkout;     // where R reads the kernels
};

// When a frame was rendered and when it was brought to the screen. A frame is a picture with all of
// its samples, or with those that there was time for before something changed: from the start of
// its first to the end of its last.
struct FrameTimes {
    Interval render;
    Interval present;         // of the last
    double milliseconds = 0;  // of each from its start, or the end of the one before, to its end
};

struct ViewFigures {
    std::vector<FrameTimes> frames;
    double first_shown = 0;  // when the first frame was on the screen, now_milliseconds
    RayTotals rays;          // of the last frame
    Image picture;           // the last frame, read back from the texture
};

class Viewer {
public:
    Viewer(Window &window, FramePipeline &pipeline, const std::string &stage, const Scene &scene,
           const ViewSettings &view);

    // Until the window is closed, or its frames are done. Throws PresenterLost.
    ViewFigures run();

private:
    struct Started {
        double at = 0;
        bool begins = false;  // a picture
    };

    bool done() const;
    bool wants_frame() const;
    Input next_input();
    void handle(const Input &input);
    void fit_to_window();
    void start_frame();
    void finish_frame();
    void keep(const FrameTimes &times, const FinishedFrame &sample);
    void finish_all();
    void draw();
    void reload();
    void keep_build_log(const std::string &log);
    void take_screenshot();
    void update_title(double milliseconds, const FinishedFrame &sample);

    Window &window_;
    FramePipeline &pipeline_;
    std::string stage_;
    ViewSettings view_;
    FlyCamera camera_;
    Screen screen_;
    Overlay overlay_;
    glm::ivec2 framebuffer_;       // its size when the picture's was last fitted to it
    std::deque<Started> started_;  // what is in flight
    int shown_ = 0;                // samples of the picture that is shown
    bool redraw_ = false;          // what is to be seen is not what was drawn last
    bool help_ = false;
    std::vector<std::string> build_log_;  // of the kernel that did not build
    int screenshots_ = 0;
    double last_input_;
    double last_title_ = 0;
    bool title_rests_ = false;  // it says that all samples are in
    ViewFigures figures_;
};

}  // namespace stagelight
