// SPDX-License-Identifier: MIT
#include "golden/suite.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "device/device_choice.h"
#include "device/renderer.h"
#include "golden/filter.h"
#include "image/outliers.h"
#include "scene/errors.h"
#include "scene/required_features.h"
#include "scene/scene_file.h"
#include "scene/stages.h"

namespace stagelight::golden {
namespace {

const std::filesystem::path source_dir = STAGELIGHT_SOURCE_DIR;

bool is_stage_scene(const std::filesystem::path &file) {
    const std::string name = file.stem().string();
    return file.extension() == ".toml" && name.size() > 3 && name[2] == '_'
           && std::all_of(name.begin(), name.begin() + 2,
                          [](char c) { return c >= '0' && c <= '9'; });
}

std::string stage_of(const std::string &scene) {
    return stage_name(stage_number(scene));
}

// Whether the device filters the scene's textures with weights of few bits, as GPUs do. Weights of
// float are off by 1e-7, those of 8 bits by 1/512.
bool filters_coarsely(const std::string &scene, const std::string &device) {
    constexpr double few_bits = 1.0 / (1 << 14);
    static std::map<std::pair<std::string, Transfer>, double> errors;
    const Transfer decode = decode_of(stage_number(scene), {});
    const auto [error, is_new] = errors.try_emplace({device, decode});
    if (is_new) {
        error->second = filter_error(choose_device(device), decode);
    }
    return error->second > few_bits;
}

reference::Terminator terminator_of(int stage, const Methods &methods) {
    const std::string name = choice(methods, "terminator");
    return stage < cutoff_stage || name == "none" ? reference::Terminator::none
           : name == "chiang"                     ? reference::Terminator::chiang
                                                  : reference::Terminator::hanika;
}

}  // namespace

std::vector<GoldenScene> all_scenes() {
    std::vector<GoldenScene> scenes;
    for (const auto &entry : std::filesystem::directory_iterator(source_dir / "scenes")) {
        if (is_stage_scene(entry.path())) {
            const std::string name = entry.path().stem().string();
            scenes.push_back(
                {name, stage_of(name), entry.path(), source_dir / "golden" / (name + ".exr")});
        }
    }
    std::ranges::sort(scenes, {}, &GoldenScene::name);
    return scenes;
}

std::vector<GoldenScene> scenes_of(const std::string &stage) {
    std::vector<GoldenScene> scenes = all_scenes();
    std::vector<std::string> stages;
    for (const GoldenScene &scene : scenes) {
        if (stages.empty() || stages.back() != scene.stage) {
            stages.push_back(scene.stage);
        }
    }
    std::erase_if(scenes, [&stage](const GoldenScene &scene) {
        return scene.stage != stage && scene.stage.substr(0, 2) != stage;
    });
    if (scenes.empty()) {
        throw UserError(fmt::format("{}: expected one of {}", stage, fmt::join(stages, ", ")));
    }
    return scenes;
}

reference::Settings reference_settings(const std::string &stage, const Scene &scene,
                                       const Methods &methods) {
    const int number = stage_number(stage);
    return {.width = width,
            .height = height,
            .max_depth = depth_of(scene, number),
            .interior = choice(methods, "interior") == "paper" ? reference::Interior::paper
                                                               : reference::Interior::full,
            .fresnel = choice(methods, "fresnel") == "exact" ? reference::Fresnel::exact
                                                             : reference::Fresnel::schlick,
            .terminator = terminator_of(number, methods),
            .decode = decode_of(number, methods)};
}

reference::Shown shown_by(const std::string &stage) {
    return stage_number(stage) == 1 ? reference::Shown::normals_and_distances
                                    : reference::Shown::light;
}

reference::Result draw_reference(const GoldenScene &golden, const Methods &methods) {
    const Scene scene = load_scene(golden.scene);
    return reference::render<double>(scene, reference_settings(golden.stage, scene, methods),
                                     shown_by(golden.stage));
}

Drawn draw_on(const GoldenScene &golden, const std::string &device, const Methods &methods) {
    const Scene scene = load_scene(golden.scene);
    require_supported(scene, stage_number(golden.stage));
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.max_depth = depth_of(scene, stage_number(golden.stage));
    settings.methods = methods;
    const cl::Device chosen = choose_device(device);
    return {chosen, Renderer(chosen, golden.stage, scene, settings).render()};
}

Image draw_device(const GoldenScene &golden, const std::string &device, const Methods &methods) {
    return draw_on(golden, device, methods).frame.image;
}

Bound bound_of(const std::string &scene, const std::string &device, const std::string &key) {
    const std::filesystem::path file = source_dir / "golden" / "tolerances.toml";
    const toml::table tolerances = toml::parse_file(file.string());
    std::vector<std::pair<std::string_view, std::string_view>> places;
    if (device == "povray") {
        places = {{scene, device}, {"every", device}};
    } else if (tolerances.at_path(scene + ".coarse_filter") && filters_coarsely(scene, device)) {
        places = {{scene, "coarse_filter"}};
    }
    places.insert(places.end(), {{scene, "every"}, {"every", "every"}});
    for (const auto &[for_scene, for_device] : places) {
        const std::string place = fmt::format("{}.{}", for_scene, for_device);
        if (const auto value = tolerances.at_path(place + '.' + key).value<double>()) {
            return {place, *value};
        }
    }
    throw UserError(fmt::format("{}: {} on {}: no {}", file.string(), scene, device, key));
}

Tolerance tolerance_of(const std::string &scene, const std::string &device) {
    const auto number = [&](const char *key) { return bound_of(scene, device, key).value; };
    return {.interior = number("interior"),
            .edge_outliers = static_cast<int>(number("edge_outliers")),
            .strays = static_cast<int>(number("strays")),
            .mean_signed_error = number("mean_signed_error")};
}

std::vector<glm::ivec2> unseen_pixels(const GoldenScene &golden, const Image &picture,
                                      const Image &truth, double tolerance) {
    std::vector<glm::ivec2> outliers;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (error_of(picture.at(x, y), truth.at(x, y)) > tolerance) {
                outliers.emplace_back(x, y);
            }
        }
    }
    constexpr double reach = 0.02;  // twice the largest shift measured; most are below 0.001
    const Scene scene = load_scene(golden.scene);
    const auto around = reference::colors_around(scene, reference_settings(golden.stage, scene, {}),
                                                 outliers, reach);
    std::vector<glm::ivec2> unseen;
    for (std::size_t i = 0; i < outliers.size(); ++i) {
        const glm::vec3 color = picture.at(outliers[i].x, outliers[i].y);
        if (std::ranges::none_of(around[i], [&](const glm::vec3 &seen) {
                return error_of(color, seen) <= tolerance;
            })) {
            unseen.push_back(outliers[i]);
        }
    }
    return unseen;
}

}  // namespace stagelight::golden
