// SPDX-License-Identifier: MIT
// A slab of glass as a closed mesh, and what is seen through it.
#pragma once

#include "reference/scenes.h"

namespace stagelight::reference {

// A slab one thick lies before a wall with a lamp near it. A ray that comes at `angle` from the
// front is split at each face; what goes on inside moves `tan` of the inner angle sideways each
// time it crosses, and what leaves at the back runs on in its first direction to where it meets the
// wall.
struct GlassSlab {
    double angle;
    double ior = 1.5;
    dvec3 color{0.95, 0.9, 0.8}, absorption{0.1, 0.6, 1.5}, sky{0.3, 0.6, 0.9};
    int max_depth = 8;

    static constexpr double front = 0.5, back = -0.5, wall = -2;
    static constexpr double height = 0.3;  // the ray is in that plane, off the facets' diagonals
    static constexpr double lamp = 1;      // its x; it is one before the wall

    double inner_angle() const { return std::asin(std::sin(angle) / ior); }
    dvec3 direction() const { return {std::sin(angle), 0, -std::cos(angle)}; }
    dvec3 eye() const { return dvec3(0, height, front) - 3.0 * direction(); }

    Scene scene() const {
        Scene scene;
        scene.background = sky;
        scene.max_depth = max_depth;
        scene.camera.position = eye();
        scene.camera.look_at = {0, height, front};
        add_plane(scene, {0, 0, 1}, {0, 0, wall}, diffuse({1, 1, 1}));
        add_point_light(scene, {lamp, height, wall + 1}, {1, 1, 1}, 1);
        add_box(scene, {-50, -50, back}, {50, 50, front},
                add_material(scene, glass(color, ior, absorption)));
        return scene;
    }

    // Lambert's cosine 1 / r over r².
    static double wall_at(double x) { return std::pow((x - lamp) * (x - lamp) + 1, -1.5); }

    // `F` is what a face reflects, from either side. After k crossings, each weakened by T, the
    // share (1 - F)² F^(k - 1) leaves, of depth k + 1, and was coloured at k + 1 faces: at the back
    // for odd k, to the wall, and at the front for even k, to the sky.
    dvec3 seen(double F) const {
        const double cross = std::tan(inner_angle()), beyond = (back - wall) * std::tan(angle);
        const dvec3 T = glm::exp(-absorption / std::cos(inner_angle()));
        dvec3 sum = F * color * sky;
        dvec3 carried = (1 - F) * color;
        for (int k = 1; k + 1 <= max_depth; ++k) {
            carried *= T * color;
            sum += (1 - F) * carried * (k % 2 == 0 ? sky : dvec3(wall_at(k * cross + beyond)));
            carried *= F;
        }
        return sum;
    }
};

// Schlick's approximation for a ray from the thin side, at that angle.
inline double schlick_at(double angle, double ior) {
    const double head_on = std::pow((1 - ior) / (1 + ior), 2);
    return head_on + (1 - head_on) * std::pow(1 - std::cos(angle), 5);
}

// Fresnel's equations in their trigonometric form (Born and Wolf, section 1.5.2), not head on.
inline double fresnel_at(double angle, double ior) {
    if (angle == 0)
        return std::pow((1 - ior) / (1 + ior), 2);
    const double inner = std::asin(std::sin(angle) / ior);
    const double across = std::sin(angle - inner) / std::sin(angle + inner);
    const double within = std::tan(angle - inner) / std::tan(angle + inner);
    return (across * across + within * within) / 2;
}

// A ball of glass over a lit floor: analytic, or a mesh of n * 2n facets with the normals of a
// sphere.
inline Scene glass_ball(int n = 0) {
    Scene scene;
    scene.width = scene.height = 48;
    scene.camera = {.position = {0, 0.6, 4}, .look_at = {0, 0, 0}, .fov = 40};
    scene.background = {0.3, 0.5, 0.8};
    add_plane(scene, {0, 1, 0}, {0, -1.2, 0}, diffuse({0.9, 0.7, 0.4}));
    add_directional_light(scene, glm::normalize(dvec3(0.3, -1, -0.4)), {1, 1, 1}, 0.8);
    const Material ball = glass({1, 1, 1}, 1.5, {0.1, 0.4, 0.8});
    if (n == 0)
        add_sphere(scene, {0, 0, 0}, 1, ball);
    else
        add_ball(scene, {0, 0, 0}, 1, n, add_material(scene, ball));
    return scene;
}

// How far pictures differ, in the mean over pixels and channels.
inline double mean_difference(const std::vector<glm::vec3> &a, const std::vector<glm::vec3> &b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const glm::vec3 off = a[i] - b[i];
        sum += std::abs(off.x) + std::abs(off.y) + std::abs(off.z);
    }
    return sum / (3 * double(a.size()));
}

}  // namespace stagelight::reference
