// SPDX-License-Identifier: MIT
#include "povray/judge.h"

#include <algorithm>
#include <limits>
#include <thread>

#include "bench/povray.h"
#include "bench/stages.h"
#include "pov/pov_export.h"
#include "scene/scene_file.h"
#include "scene/stages.h"

namespace stagelight::povray {
namespace {

Scene scene_in_common(const std::filesystem::path &file) {
    Scene scene = load_scene(file);
    for (Light &light : scene.lights) {
        light.range = std::numeric_limits<double>::infinity();
    }
    for (Material &material : scene.materials) {
        if (material.type == MaterialType::dielectric) {
            material.color = glm::dvec3(1);
        } else if (material.texture != no_texture) {
            material.type = MaterialType::diffuse;
        }
    }
    return scene;
}

}  // namespace

std::vector<golden::GoldenScene> judged_scenes() {
    std::vector<golden::GoldenScene> scenes = golden::all_scenes();
    const std::filesystem::path tests = std::filesystem::path(STAGELIGHT_SOURCE_DIR) / "tests";
    scenes.push_back({.name = "11_glass_cube",
                      .stage = "11_full_tracer",
                      .scene = tests / "oclgrind" / "glass_cube.toml",
                      .golden = {}});
    return scenes;
}

Verdict judge(const golden::GoldenScene &golden, const std::filesystem::path &folder) {
    const Scene scene = scene_in_common(golden.scene);
    const int number = stage_number(golden.stage);
    RenderSettings settings = bench::settings_of(golden.stage, scene, {{"fresnel", "exact"}});
    settings.width = golden::width;
    settings.height = golden::height;
    const std::filesystem::path file = folder / (golden.name + ".pov");
    export_pov(scene,
               {.width = settings.width,
                .height = settings.height,
                .max_depth = settings.max_depth,
                .decode = decode_of(number, settings.methods),
                .shows_normals = number == 1},
               file);
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    Verdict verdict{.povray =
                        bench::run_povray(file, settings.width, settings.height, threads).image,
                    .truth = bench::reference_of(golden.stage, scene, settings),
                    .comparison = {}};
    verdict.comparison = compare(verdict.povray, verdict.truth.image, verdict.truth.edge,
                                 golden::tolerance_of(golden.name, "povray"));
    return verdict;
}

}  // namespace stagelight::povray
