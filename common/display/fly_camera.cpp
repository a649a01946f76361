// SPDX-License-Identifier: MIT
#include "display/fly_camera.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "scene/normalize.h"

namespace stagelight {
namespace {

constexpr double crossing_time = 5;       // seconds
constexpr double speed_per_notch = 1.25;  // a factor
constexpr double most_speed_change = 1000;
// A key just found pressed was so for an unknown part of the time that has passed, which may be
// a long wait: count this much.
constexpr double first_step = 1.0 / 30;  // seconds

const double turn_per_pixel = glm::radians(0.15);
const double steepest = glm::radians(89.0);  // at the pole there is no left and right

struct Axes {
    glm::dvec3 forward;
    glm::dvec3 right;
    glm::dvec3 up;  // the scene's, not the picture's
};

Axes axes_of(const CameraDescription &camera) {
    const glm::dvec3 forward = normalize(camera.look_at - camera.position);
    const glm::dvec3 up = normalize(camera.up);
    return {forward, normalize(glm::cross(forward, up)), up};
}

}  // namespace

FlyCamera::FlyCamera(const CameraDescription &start, double scene_size)
    : camera_(start), start_speed_(scene_size / crossing_time), speed_(start_speed_) {
    assert(scene_size > 0 && std::isfinite(scene_size));
}

bool FlyCamera::update(const Input &input, double seconds) {
    speed_ = std::clamp(speed_ * std::pow(speed_per_notch, input.scroll),
                        start_speed_ / most_speed_change, start_speed_ * most_speed_change);
    const bool turned = look(input.look);
    return move(input, seconds) || turned;
}

// Yaw around the scene's up, pitch above its horizon. A scene that starts steeper than
// the limit may stay so, but gets no steeper.
bool FlyCamera::look(const glm::dvec2 &way) {
    if (way == glm::dvec2(0, 0)) {
        return false;
    }
    const auto [forward, right, up] = axes_of(camera_);
    const glm::dvec3 ahead = glm::cross(up, right);  // forward, on the horizon

    const double pitch = std::atan2(glm::dot(forward, up), glm::dot(forward, ahead));
    const double limit = std::max(steepest, std::abs(pitch));
    const double new_pitch = std::clamp(pitch - way.y * turn_per_pixel, -limit, limit);
    const double yaw = way.x * turn_per_pixel;
    const glm::dvec3 new_ahead = std::cos(yaw) * ahead + std::sin(yaw) * right;
    const glm::dvec3 new_forward = std::cos(new_pitch) * new_ahead + std::sin(new_pitch) * up;
    camera_.look_at =
        camera_.position + glm::distance(camera_.look_at, camera_.position) * new_forward;
    return true;
}

bool FlyCamera::move(const Input &input, double seconds) {
    const auto [forward, right, up] = axes_of(camera_);
    const std::array<bool, 6> held = {input.forward, input.back, input.right,
                                      input.left,    input.up,   input.down};
    const std::array<glm::dvec3, 6> directions = {forward, -forward, right, -right, up, -up};
    glm::dvec3 direction(0, 0, 0);
    glm::dvec3 way(0, 0, 0);
    for (std::size_t i = 0; i < held.size(); ++i) {
        if (held[i]) {
            direction += directions[i];
            way += directions[i] * (held_[i] ? seconds : std::min(seconds, first_step));
        }
    }
    held_ = held;
    if (way == glm::dvec3(0, 0, 0)) {
        return false;  // adding 0 would turn a -0 of the scene's into 0
    }
    way *= speed_ / std::max(1.0, glm::length(direction));  // no faster on a diagonal
    camera_.position += way;
    camera_.look_at += way;
    return true;
}

}  // namespace stagelight
