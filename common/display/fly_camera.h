// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "display/input.h"
#include "scene/scene.h"

namespace stagelight {

// A scene's camera, flown by hand. Until something is pressed it is the scene's to the last bit.
class FlyCamera {
public:
    // `scene_size`, > 0, is the way across the scene in its units: five seconds of flight at first.
    FlyCamera(const CameraDescription &start, double scene_size);

    // `seconds` have passed since the last call. True when the camera has changed.
    bool update(const Input &input, double seconds);

    const CameraDescription &camera() const { return camera_; }
    double speed() const { return speed_; }  // scene units a second

private:
    bool look(const glm::dvec2 &way);
    bool move(const Input &input, double seconds);

    CameraDescription camera_;
    double start_speed_;
    double speed_;
    std::array<bool, 6> held_{};  // the directions of the last call
};

}  // namespace stagelight
