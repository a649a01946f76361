// SPDX-License-Identifier: MIT
#include "povray/judge.h"

#include <algorithm>
#include <limits>
#include <thread>

#include "bench/povray.h"
#include "bench/stages.h"
#include "golden/suite.h"
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
    for (Texture &texture : scene.textures) {
        texture.wrap_u = texture.wrap_v = Wrap::repeat;
    }
    for (Material &material : scene.materials) {
        material.alpha_cutoff = 0;
        if (material.type == MaterialType::dielectric) {
            material.color = glm::dvec3(1);
        } else if (material.texture != no_texture) {
            material.type = MaterialType::diffuse;
        }
    }
    return scene;
}

}  // namespace

std::vector<JudgedScene> judged_scenes() {
    std::vector<JudgedScene> scenes;
    for (const golden::GoldenScene &golden : golden::all_scenes()) {
        if (golden.name == "11_glass") {
            continue;  // Suzanne's head and eyes overlap and have holes: what is inside is not
                       // defined
        }
        scenes.push_back({.name = golden.name,
                          .stage = golden.stage,
                          .file = golden.scene,
                          .width = golden::width,
                          .height = golden::height});
    }
    const auto add = [&scenes](const std::filesystem::path &file, int width, int height) {
        scenes.push_back({.name = "11_" + file.stem().string(),
                          .stage = bench::full_tracer(),
                          .file = file,
                          .width = width,
                          .height = height});
    };
    const std::filesystem::path tests = std::filesystem::path(STAGELIGHT_SOURCE_DIR) / "tests";
    add(tests / "oclgrind" / "glass_cube.toml", golden::width, golden::height);
    constexpr int small_width = 160, small_height = 96;
    for (const auto &entry : std::filesystem::directory_iterator(tests / "povray" / "scenes")) {
        if (entry.path().extension() == ".toml") {
            add(entry.path(), small_width, small_height);
        }
    }
    std::ranges::sort(scenes, {}, &JudgedScene::name);
    return scenes;
}

Verdict judge(const JudgedScene &judged, const std::filesystem::path &folder) {
    const Scene scene = scene_in_common(judged.file);
    const int number = stage_number(judged.stage);
    // As POV-Ray has it: Fresnel's own equations, and shadows of facets.
    RenderSettings settings =
        bench::settings_of(judged.stage, scene, {{"fresnel", "exact"}, {"terminator", "none"}});
    settings.width = judged.width;
    settings.height = judged.height;
    const std::filesystem::path file = folder / (judged.name + ".pov");
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
                    .truth = bench::reference_of(judged.stage, scene, settings),
                    .comparison = {}};
    verdict.comparison = compare(verdict.povray, verdict.truth.image, verdict.truth.edge,
                                 golden::tolerance_of(judged.name, "povray"));
    return verdict;
}

}  // namespace stagelight::povray
