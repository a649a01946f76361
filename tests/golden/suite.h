// SPDX-License-Identifier: MIT
// The golden suite: every scene in scenes/NN_*.toml, drawn by the stage of its number.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "device/methods.h"
#include "image/compare.h"
#include "image/golden_file.h"
#include "image/image.h"
#include "reference/reference.h"

namespace stagelight::golden {

constexpr int width = 320;
constexpr int height = 192;

struct GoldenScene {
    std::string name;              // "04_interior"
    std::string stage;             // "04_refraction_beer"
    std::filesystem::path scene;   // scenes/04_interior.toml
    std::filesystem::path golden;  // golden/04_interior.exr
};

// For GoogleTest, which else shows bytes.
inline void PrintTo(const GoldenScene &scene, std::ostream *out) {
    *out << scene.name;
}

// Sorted by name.
std::vector<GoldenScene> all_scenes();

// The scenes of `stage`, which is "04" or "04_refraction_beer". Throws UserError with the list
// of stages for any other.
std::vector<GoldenScene> scenes_of(const std::string &stage);

// How the reference draws what `stage` draws of a scene by the chosen methods, at the goldens'
// size.
reference::Settings reference_settings(const std::string &stage, const Scene &scene,
                                       const Methods &methods);
reference::Shown shown_by(const std::string &stage);

// The picture as the double-precision reference draws it, by the chosen methods.
reference::Result draw_reference(const GoldenScene &scene, const Methods &methods = {});

// What the reference sees around the centres of `pixels` (reference::colors_around).
std::vector<std::vector<glm::vec3>>
draw_around(const GoldenScene &scene, const std::vector<glm::ivec2> &pixels, double reach);

// The picture as the stage's kernel draws it on the device that `device` stands for (--device).
Image draw_device(const GoldenScene &scene, const std::string &device, const Methods &methods = {});

// What golden/tolerances.toml allows the scene on that device. Throws UserError for a file that
// does not say.
Tolerance tolerance_of(const std::string &scene, const std::string &device);
// How many pixels on edges may show what the reference sees nowhere around them.
int unseen_of(const std::string &scene, const std::string &device);

}  // namespace stagelight::golden
