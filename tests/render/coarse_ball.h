// SPDX-License-Identifier: MIT
// A coarse mesh that stands for a ball, and how far its light is off the ball's.
#pragma once

#include <cmath>

#include "reference/camera.h"
#include "render/on_each_device.h"

namespace stagelight::render {

// n * 2n facets around `center`, lit from the side.
inline Scene coarse_ball(int n, dvec3 light = {-1, -0.45, -0.15}, dvec3 center = {0, 0, 0}) {
    Scene scene = one_pixel(center + dvec3(0.3, 0.6, 4), center);
    scene.width = scene.height = 120;
    scene.camera.fov = 32;
    add_ball(scene, center, 1, n, add_material(scene, diffuse({1, 1, 1})));
    add_directional_light(scene, glm::normalize(light), {1, 1, 1}, 1);
    return scene;
}

// From Lambert's cosine on the ball itself, in pixels that are well within its outline.
struct OffTheBall {
    double rms = 0;
    int black = 0;  // of pixels that are lit by 0.02 at least

    OffTheBall(const Image &image, const Scene &scene) {
        const dvec3 center = scene.camera.look_at;
        int count = 0;
        for (int y = 0; y < scene.height; ++y) {
            for (int x = 0; x < scene.width; ++x) {
                const auto eye =
                    primary_ray(scene.camera, scene.width, scene.height, x + 0.5, y + 0.5);
                const double t = intersect_sphere(eye, center, 1.0).value_or(0);
                const dvec3 normal = eye.origin + t * eye.direction - center;
                if (t == 0 || glm::dot(normal, -eye.direction) < 0.35) {
                    continue;
                }
                const double light = std::max(0.0, glm::dot(normal, -scene.lights[0].direction));
                const double is = image.at(x, y).x;
                rms += (is - light) * (is - light);
                black += light > 0.02 && is == 0;
                ++count;
            }
        }
        rms = std::sqrt(rms / count);
    }
};

inline RenderSettings by_terminator(const char *method, const Scene &scene,
                                    const char *width = "1") {
    RenderSettings settings = settings_of(scene);
    settings.methods = {{"terminator", method}, {"width", width}};
    return settings;
}

}  // namespace stagelight::render
