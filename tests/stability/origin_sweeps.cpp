// SPDX-License-Identifier: MIT
// Where the ways to leave a surface show: rays that start too near to it are blocked by it (acne),
// and those that start too far off are beyond what should have blocked them (leaks). Whole pictures
// beside the reference in double, with pixels on edges left out.
#include <algorithm>
#include <cmath>
#include <map>

#include "reference/reference.h"
#include "render/moved.h"
#include "render/on_each_device.h"
#include "scene/large_triangles.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

using glm::dvec3, glm::vec3;
using render::each_device, render::device_name;

// By more than rounding does to shading: a shadow more or less.
double wrong_pixels(const Image &picture, const reference::Result &truth) {
    double wrong = 0;
    for (std::size_t i = 0; i < truth.edge.size(); ++i) {
        const double error = glm::distance(picture.pixels[i], truth.image.pixels[i]);
        const double allowed = 0.02 * std::max(1.0F, truth.image.pixels[i].x);
        wrong += truth.edge[i] == 0 && !(error < allowed) ? 1 : 0;
    }
    return wrong;
}

const char *const methods[] = {"error_bound", "scaled", "fixed", "integer"};

class StabilityStage11Origin : public render::OnEachDevice {
protected:
    // Rusticl, which takes seconds to build stage 11, shows the same of one ray at a time.
    static const char *stage() { return is_rusticl(GetParam()) ? "05_meshes" : "11_full_tracer"; }

    // The share of the pixels off edges that each method has wrong.
    static std::map<std::string, double> wrong_by_method(const Scene &scene,
                                                         const char *with_stage) {
        const auto truth =
            reference::render<double>(scene, {scene.width, scene.height, scene.max_depth});
        const auto inside = double(std::ranges::count(truth.edge, 0));
        EXPECT_GT(inside, double(truth.edge.size()) / 3);
        std::map<std::string, double> wrong;
        for (const char *method : methods) {
            RenderSettings settings = render::settings_of(scene);
            settings.methods = {{"width", "1"}, {"origin", method}};
            const Image picture = renderer(with_stage, scene, settings).render().image;
            wrong[method] = wrong_pixels(picture, truth) / inside;
        }
        return wrong;
    }

    static void measure(Sweep &sweep, double x, const Scene &scene,
                        const char *with_stage = stage()) {
        SCOPED_TRACE(x);
        const auto wrong = wrong_by_method(scene, with_stage);
        for (const char *method : methods) {
            sweep.add(method, x, wrong.at(method));
        }
    }
};
INSTANTIATE_TEST_SUITE_P(On, StabilityStage11Origin, each_device(), device_name);

// A ball, and a block from low to high, stand on the floor; the walls and the roof of a shed, open
// to the front, are thin. All is lit from the front and, but for the inside of the shed, from
// behind.
Scene shed(const dvec3 &block_low = {0.8, 0, 0}, const dvec3 &block_high = {2.8, 0.3, 2}) {
    Scene scene = render::one_pixel({0.2, 1.4, 4}, {0, 0.5, 0});
    scene.width = 64;
    scene.height = 40;
    const int white = reference::add_material(scene, reference::diffuse(dvec3(0.8)));
    reference::add_plane(scene, {0, 1, 0}, dvec3(0), reference::diffuse(dvec3(0.8)));
    reference::add_sphere(scene, {-1.2, 0.5, 0.5}, 0.5, reference::diffuse(dvec3(0.8)));
    reference::add_box(scene, block_low, block_high, white);
    const dvec3 low(-0.5, 0, -1.2), high(0.7, 1.2, 0);
    constexpr double thickness = 0.01;
    reference::add_box(scene, low, {low.x + thickness, high.y, high.z}, white);
    reference::add_box(scene, {high.x - thickness, low.y, low.z}, high, white);
    reference::add_box(scene, low, {high.x, high.y, low.z + thickness}, white);
    reference::add_box(scene, {low.x, high.y - thickness, low.z}, high, white);
    reference::add_point_light(scene, {-1, 3, -4}, dvec3(1), 8);
    reference::add_point_light(scene, {2, 2.5, 4}, dvec3(1), 8);
    return scene;
}

// As float has it, so that the reference draws the same scene.
Scene rounded(const Scene &scene) {
    return render::moved(scene, 1, [](const dvec3 &point) { return dvec3(vec3(point)); });
}

Question about(const char *name, const char *title, const char *x_label, const char *stated) {
    return {.name = name,
            .kind = "origin",
            .title = title,
            .x_label = x_label,
            .y_label = "share of pixels with a wrong shadow",
            .limit = 1e-4,
            .stated = stated};
}

TEST_P(StabilityStage11Origin, SmallScenes) {
    Sweep sweep(about("origin_small", "Small scenes", "1 / size", "to a size of 1e-4"), GetParam());
    for (int power = 0; power <= 4; ++power) {
        measure(sweep, std::pow(10, power), rounded(render::scaled(shed(), std::pow(10, -power))));
    }
    sweep.expect_holds("error_bound", 1e4);
    sweep.expect_holds("scaled", 1e4);
    sweep.expect_fails("fixed", 1e2);
    sweep.expect_fails("integer", 1e4);
}

TEST_P(StabilityStage11Origin, LargeScenes) {
    Sweep sweep(about("origin_large", "Large scenes", "size", "to a size of 1e6"), GetParam());
    for (int power = 0; power <= 6; ++power) {
        measure(sweep, std::pow(10, power), rounded(render::scaled(shed(), std::pow(10, power))));
    }
    sweep.expect_holds("error_bound", 1e6);
    sweep.expect_holds("scaled", 1e6);
    sweep.expect_fails("fixed", 1e5);
}

TEST_P(StabilityStage11Origin, FarFromTheOrigin) {
    Sweep sweep(about("origin_offset", "Scenes far from the origin", "coordinates / size",
                      "to coordinates of 1e5 sizes"),
                GetParam());
    for (int power = 1; power <= 5; ++power) {
        const dvec3 offset = std::pow(10, power) * glm::normalize(dvec3(3, 2, -4));
        measure(sweep, std::pow(10, power), rounded(render::shifted(shed(), offset)));
    }
    sweep.expect_holds("error_bound", 1e5);
    sweep.expect_fails("scaled", 1e5);  // as from far away: see below
    sweep.expect_fails("fixed", 1e5);
    sweep.expect_fails("integer", 1e5);
}

TEST_P(StabilityStage11Origin, CameraFarAway) {
    Sweep sweep(about("origin_far", "Camera far away", "distance / size", "to 1e5 sizes away"),
                GetParam());
    for (int power = 1; power <= 5; ++power) {
        Scene scene = shed();
        const double distance = std::pow(10, power);
        scene.camera.position = distance * glm::normalize(dvec3(0.05, 0.1, 1));
        scene.camera.fov = glm::degrees(2 * std::atan(2.3 / distance));
        measure(sweep, distance, rounded(scene));
    }
    sweep.expect_holds("error_bound", 1e5);
    sweep.expect_fails("scaled", 1e5);  // a fifth of the scene is much to be off a surface
}

TEST_P(StabilityStage11Origin, LightCloseToTheFloor) {
    Sweep sweep(
        about("origin_low_light", "Lights close to the floor", "1 / height", "to a height of 1e-5"),
        GetParam());
    for (int power = 1; power <= 6; ++power) {
        Scene scene = shed();
        const double height = std::pow(10, -power);
        for (Light &light : scene.lights) {
            light.position.y = height;
            light.intensity /= height;
        }
        measure(sweep, std::pow(10, power), rounded(scene));
    }
    sweep.expect_holds("error_bound", 1e5);
    sweep.expect_fails("fixed", 1e3);
}

// From within the gap between the floor and a thin plate: it is dark there. The tree is as deep as
// the shed's with its block, so that the kernels are the same.
TEST_P(StabilityStage11Origin, DarkGap) {
    Sweep sweep(about("origin_gap", "Light through a thin plate", "1 / the gap below it",
                      "to a gap of 1e-6"),
                GetParam());
    for (int power = 1; power <= 6; ++power) {
        const double gap = std::pow(10, -power);
        Scene scene = shed({-2, gap, 2}, {2, 1.1 * gap, 5});
        scene.camera.position.y = gap / 2;
        scene.camera.look_at.y = gap / 2;
        measure(sweep, std::pow(10, power), rounded(scene));
    }
    sweep.expect_holds("error_bound", 1e6);
    sweep.expect_fails("scaled", 1e6);
    sweep.expect_fails("fixed", 1e4);
}

// A coin of 0.05, just off a ground that reaches as far as `reach` on every side.
Scene coin_on_ground(double reach, const Material &of_ground) {
    Scene scene = render::one_pixel({0, 1.5, 2}, {0, 0, 0});
    scene.width = 64;
    scene.height = 40;
    scene.background = dvec3(0.5, 0.75, 1);
    const int ground = reference::add_material(scene, of_ground);
    const dvec3 left(-reach, 0, -reach), right(reach, 0, -reach), near(reach, 0, reach),
        far(-reach, 0, reach);
    reference::add_flat_triangle(scene, near, right, left, ground);
    reference::add_flat_triangle(scene, far, near, left, ground);
    const int red = reference::add_material(scene, reference::diffuse({1, 0.25, 0.125}));
    reference::add_box(scene, {-0.5, 0.001, -0.5}, {0.5, 0.05, 0.5}, red);
    reference::add_directional_light(scene, {-1, -0.5, 0.25}, dvec3(1), 1);
    scene = rounded(scene);
    cut_large_triangles(scene);
    return scene;
}

// Beside the picture of a small ground: edges count here, of which rounding may move a pixel. The
// horizon is out of sight. Stage 05 has all that this needs, and one kernel for all grounds.
TEST_P(StabilityStage11Origin, ACoinOnALargeGround) {
    const auto drawn = [&](double reach, const Material &ground, const char *method) {
        const Scene scene = coin_on_ground(reach, ground);
        RenderSettings settings = render::settings_of(scene);
        settings.methods = {{"origin", method}};
        return renderer("05_meshes", scene, settings).render().image.pixels;
    };
    const auto sweep_over = [&](Question question, const Material &ground) {
        question.limit = 1e-3;
        Sweep sweep(question, GetParam());
        const auto truth = drawn(10, ground, "error_bound");
        for (int power = 2; power <= 6; ++power) {
            const double reach = std::pow(10, power);
            for (const char *method : methods) {
                const auto pixels = drawn(reach, ground, method);
                double wrong = 0;
                for (std::size_t i = 0; i < pixels.size(); ++i) {
                    wrong += glm::distance(pixels[i], truth[i]) < 0.02 ? 0 : 1;
                }
                sweep.add(method, reach, wrong / double(pixels.size()));
            }
        }
        sweep.expect_holds("error_bound", 1e6);
    };
    sweep_over(about("origin_ground", "A coin on a large ground", "size of the ground / coin",
                     "to a ground of 1e6 coins"),
               reference::diffuse(dvec3(0.75)));
    sweep_over(about("origin_mirror_ground", "A coin on a large mirror",
                     "size of the mirror / coin", "to a mirror of 1e6 coins"),
               reference::mirror(dvec3(0.75)));
}

// A light at `height` above a floor, or above the ball on it, seen from as near; half-way to it a
// bead casts a shadow. On the ball coordinates are about 1, of which float has seven digits.
Scene light_above(bool is_ball, double height) {
    const dvec3 normal = is_ball ? dvec3(0.6, 0.8, 0) : dvec3(0, 1, 0);
    const dvec3 foot = is_ball ? 1.25 * normal : dvec3(0);
    const double size = height > 0 ? height : 1;
    const dvec3 along(normal.y, -normal.x, 0), across(0, 0, 1);
    Scene scene =
        render::one_pixel(foot + size * (2.0 * across + 0.5 * along + 1.5 * normal), foot);
    scene.camera.up = normal;
    scene.width = 64;
    scene.height = 40;
    const double floor = is_ball ? -1.25 : 0;
    reference::add_plane(scene, {0, 1, 0}, {0, floor, 0}, reference::diffuse(dvec3(1)));
    reference::add_sphere(scene, dvec3(0, is_ball ? 0 : -9, 0), 1.25, reference::diffuse(dvec3(1)));
    reference::add_sphere(scene, foot + size * (0.5 * normal + 0.2 * along), size / 8,
                          reference::diffuse(dvec3(0)));
    reference::add_point_light(scene, foot + height * normal, dvec3(1), size * size);
    return scene;
}

TEST_P(StabilityStage11Origin, LightCloseToAFloorAndABall) {
    Sweep floor(about("origin_light_floor", "A light comes down to a floor", "1 / its height",
                      "to a height of 1e-7"),
                GetParam());
    Sweep ball(about("origin_light_ball", "A light comes down to a ball", "1 / its height",
                     "to a height of 1e-4"),
               GetParam());
    // A small kernel, which has all that this needs.
    const char *const with_stage = "02_shading_shadows";
    for (const int power : {1, 3, 5, 7}) {
        const double x = std::pow(10, power);
        measure(floor, x, rounded(light_above(false, 1 / x)), with_stage);
    }
    for (const int power : {1, 3, 4, 5}) {
        const double x = std::pow(10, power);
        measure(ball, x, rounded(light_above(true, 1 / x)), with_stage);
    }
    for (const char *method : {"error_bound", "scaled"}) {
        floor.expect_holds(method, 1e7);
        ball.expect_holds(method, 1e4);
        ball.expect_fails(method, 1e5);
    }
    for (Sweep *sweep : {&floor, &ball}) {
        sweep->expect_fails("fixed", 1e3);
        sweep->expect_fails("integer", 1e5);
    }
    // In the surface itself: no light, whatever rounding does.
    for (const bool is_ball : {false, true}) {
        for (const auto &[method, wrong] : wrong_by_method(light_above(is_ball, 0), with_stage)) {
            EXPECT_EQ(wrong, 0) << method << (is_ball ? ", ball" : ", floor");
        }
    }
}

}  // namespace
}  // namespace stagelight::stability
