// SPDX-License-Identifier: MIT
// Where light ends on a ball of facets by each rule, the coarser it is, and the farther from the
// origin. The truth is the ball.
#include "render/coarse_ball.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

class StabilityStage11Terminator : public render::OnEachDevice {
protected:
    static double off(const char *method, const Scene &scene) {
        const Frame frame =
            renderer("11_full_tracer", scene, render::by_terminator(method, scene)).render();
        return render::OffTheBall(frame.image, scene).rms;
    }
};
INSTANTIATE_TEST_SUITE_P(On, StabilityStage11Terminator, render::each_device(),
                         render::device_name);

Question about(const char *name, const char *title, const char *x_label, const char *stated) {
    return {.name = name,
            .kind = "terminator",
            .title = title,
            .x_label = x_label,
            .y_label = "RMS error of its light",
            .limit = 1.0 / 255,
            .stated = stated};
}

TEST_P(StabilityStage11Terminator, OfACoarseBall) {
    Sweep sweep(about("terminator", "A ball of facets", "degrees that a facet spans",
                      "to facets of 15 degrees"),
                GetParam());
    for (const int rows : {48, 24, 12, 8, 6}) {
        for (const char *method : {"none", "chiang", "hanika"}) {
            sweep.add(method, 180.0 / rows, off(method, render::coarse_ball(rows)));
        }
    }
    sweep.expect_holds("hanika", 15);  // beyond, blended normals are not the ball's
    sweep.expect_fails("none", 15);
    sweep.expect_fails("chiang", 7.5);
}

TEST_P(StabilityStage11Terminator, OfABallFarFromTheOrigin) {
    Sweep sweep(about("terminator_offset", "A ball of facets far from the origin",
                      "coordinates / radius", "to coordinates of 1,000 radii"),
                GetParam());
    for (int power = 0; power <= 5; ++power) {
        const glm::dvec3 center = std::pow(10, power) * glm::normalize(glm::dvec3(3, 2, -4));
        const Scene scene = render::coarse_ball(12, {-1, -0.45, -0.15}, center);
        for (const char *method : {"none", "hanika"}) {
            sweep.add(method, std::pow(10, power), off(method, scene));
        }
    }
    sweep.expect_holds("hanika", 1e3);
    sweep.expect_fails("hanika", 1e5);  // float has no more digits for what is lifted
    sweep.expect_fails("none", 1);
}

}  // namespace
}  // namespace stagelight::stability
