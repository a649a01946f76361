// SPDX-License-Identifier: MIT
// The golden suite: every scene in scenes/NN_*.toml, drawn by the stage of its number.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "device/methods.h"
#include "device/renderer.h"
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

// The picture as the stage's kernel draws it on the device that `device` stands for (--device).
struct Drawn {
    cl::Device device;
    Frame frame;
};
Drawn draw_on(const GoldenScene &scene, const std::string &device, const Methods &methods = {});
Image draw_device(const GoldenScene &scene, const std::string &device, const Methods &methods = {});

// A number of golden/tolerances.toml, and where it stands: "04_interior.every".
struct Bound {
    std::string place;
    double value = 0;
};

// The one that holds for the scene on that device; `key` is a member of Tolerance, or "unseen": how
// many pixels on edges may show what the reference sees nowhere around them. Throws UserError for a
// file that does not say.
Bound bound_of(const std::string &scene, const std::string &device, const std::string &key);
Tolerance tolerance_of(const std::string &scene, const std::string &device);

// The pixels beyond `tolerance` that do not show what the reference sees up to a fiftieth of a
// pixel beside: rounding alone moves none further.
std::vector<glm::ivec2> unseen_pixels(const GoldenScene &scene, const Image &picture,
                                      const Image &truth, double tolerance);

}  // namespace stagelight::golden
