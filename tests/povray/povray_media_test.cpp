// SPDX-License-Identifier: MIT
// POV-Ray among dielectrics in each other, held to what follows on paper.
#include <fstream>

#include "bench/povray.h"
#include "pov/pov_export.h"
#include "reference/layers.h"
#include "scene/temporary_folder.h"

namespace stagelight::povray {
namespace {

using glm::dvec3;

// What half precision leaves of values below 1.
constexpr double rounding = 0.0005;

dvec3 drawn(const std::filesystem::path &file) {
    return bench::run_povray(file, 1, 1, 1).image.at(0, 0);
}

TEST(PovRayMedia, AreThereByPrecedence) {
    const TemporaryFolder folder;
    for (const reference::LayeredScene &it : reference::layered_scenes()) {
        SCOPED_TRACE(it.what);
        const std::filesystem::path file = folder.path() / "layers.pov";
        export_pov(it.scene, {.width = 1, .height = 1, .max_depth = it.scene.max_depth}, file);
        reference::expect_near(drawn(file), it.expected(), rounding);
    }
}

// By its own rule, which the exporter goes around: POV-Ray absorbs by all interiors that a ray is
// in, and where it goes from one back into another, reflects nothing.
//
// A ball of glass, index 1.5, radius 1.5, that absorbs a, and in its middle a bubble, index 1,
// radius 0.5, looked at head-on: F = 0.04 at each wall where something is reflected. With paths of
// two walls or of four, and a background of 1, is seen what the first wall reflects, F; what the
// second does, which comes out again by the first, after 1 unit of glass each way; and what goes
// through all four, 3 units of glass, one of them the bubble, one of the walls without a loss.
TEST(PovRayMedia, OfItsOwnAbsorbInEachOtherAndReflectNothingBack) {
    constexpr double F = 0.04, T = 1 - F;
    const dvec3 absorption(0.1, 0.5, 1);
    const auto after = [&](double way) { return glm::exp(-way * absorption); };
    const dvec3 expected = F + T * F * T * after(2) + T * T * T * after(3);

    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "own.pov";
    std::ofstream(file) <<
        R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 adc_bailout 0 }
camera { location <0, 0, 5> look_at 0 }
background { rgb 1 }
#declare clear = texture {
  pigment { rgb 1 filter 1 }
  finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel on } conserve_energy }
}
sphere { 0, 1.5 texture { clear } hollow
  interior { ior 1.5 media { absorption rgb <0.1, 0.5, 1> samples 1, 1 intervals 1 } } }
sphere { 0, 0.5 texture { clear } hollow interior { ior 1 } }
)";
    reference::expect_near(drawn(file), expected, rounding);
}

}  // namespace
}  // namespace stagelight::povray
