// SPDX-License-Identifier: MIT
#include "bench/peers/povray_race.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "bench/contest.h"
#include "bench/povray.h"
#include "bench/stages.h"
#include "device/renderer.h"
#include "image/image_io.h"
#include "pov/pov_export.h"
#include "scene/scene_file.h"
#include "scene/stages.h"

namespace stagelight::bench {
namespace {

constexpr int rounds = 5;
constexpr int width = 800;
constexpr int height = 480;

// POV-Ray turns a smooth normal to the eye, we a facet: on silhouettes, and in the glass of smooth
// meshes, where all is edges, that is not the same.
constexpr Agreement agreement{.edges = 3e-2, .mean_signed_error = 3e-3};

// POV-Ray has Fresnel's own equations, and shadows of facets, where the stage knows others.
Methods methods_in_common(const std::string &stage) {
    Methods methods{{"fresnel", "exact"}, {"terminator", "none"}};
    std::erase_if(methods, [known = methods_of(stage_number(stage))](const auto &method) {
        return std::ranges::find(known, method.first, &Method::kind) == known.end();
    });
    return methods;
}

RenderSettings settings_for(const std::string &stage, const Scene &scene) {
    RenderSettings settings = settings_of(stage, scene, methods_in_common(stage));
    settings.width = width;
    settings.height = height;
    return settings;
}

// The picture, and how far it is from the truth.
void write_pictures(const Contestant &contestant, const Image &truth,
                    const std::filesystem::path &folder, const std::string &name) {
    constexpr float amplified = 16;
    Image difference = contestant.image;
    std::ranges::transform(contestant.image.pixels, truth.pixels, difference.pixels.begin(),
                           [](const glm::vec3 &picture, const glm::vec3 &true_one) {
                               return amplified * glm::abs(picture - true_one);
                           });
    write_image(contestant.image, folder / (name + ".png"), Transfer::srgb);
    write_image(difference, folder / (name + "_difference.png"), Transfer::none);
}

// What POV-Ray's picture took, the medians of all rounds.
struct PovRayTimes {
    std::vector<double> parsing, wall;
};

Contestant povray(const std::filesystem::path &scene, int threads, PovRayTimes &times) {
    return {"POV-Ray 3.7", [scene, threads, &times] {
                PovRayPicture picture = run_povray(scene, width, height, threads);
                times.parsing.push_back(picture.parsing);
                times.wall.push_back(picture.wall);
                return Drawn{std::move(picture.image), 0, picture.tracing};
            }};
}

}  // namespace

bool race_povray(const cl::Device &device, int threads, ordered_json &report) {
    const std::string stage = full_tracer();
    const Scene scene =
        load_scene(std::filesystem::path(STAGELIGHT_SOURCE_DIR) / "scenes" / (stage + ".toml"));
    const RenderSettings settings = settings_for(stage, scene);
    const std::filesystem::path folder = std::filesystem::path("out") / "peers";
    std::filesystem::create_directories(folder);
    const std::filesystem::path exported = folder / "room.pov";
    export_pov(
        scene,
        {width, height, settings.max_depth, decode_of(stage_number(stage), settings.methods)},
        exported);

    say(stage + ".toml: the reference, to hold both pictures to");
    const reference::Result truth = reference_of(stage, scene, settings);
    Renderer renderer(device, stage, scene, settings);
    PovRayTimes times;
    std::vector<Contestant> contestants{ours(renderer, stage), povray(exported, threads, times)};
    const bool all_right = agree(contestants, truth, agreement);
    write_pictures(contestants[0], truth.image, folder, "ours");
    write_pictures(contestants[1], truth.image, folder, "povray");
    if (!all_right) {
        return false;
    }
    say(fmt::format("{}.toml: {} rounds", stage, rounds));
    time_in_turn(contestants, rounds);

    const Comparison between =
        compare(contestants[1].image, contestants[0].image, truth.edge, Tolerance());
    fmt::print("\n{}.toml: {}x{}, one ray a pixel, {} threads\n{}", stage, width, height, threads,
               table_of(contestants));
    fmt::print("POV-Ray's ms are those that it calls Trace Time; it reads the scene in {:.0f} ms, "
               "and takes {:.0f} ms in all\n"
               "one from the other: {}\n"
               "{}: both pictures, and 16 times how far they are from the reference\n",
               median(times.parsing), median(times.wall), to_string(between), folder.string());
    report["room"] = {{"scene", stage + ".toml"},
                      {"size", {width, height}},
                      {"threads", threads},
                      {"povray", {{"parsing", times.parsing}, {"wall", times.wall}}},
                      {"tracers", json_of(contestants)},
                      {"between", to_string(between)}};
    return true;
}

}  // namespace stagelight::bench
