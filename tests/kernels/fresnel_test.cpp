// SPDX-License-Identifier: MIT
// Fresnel's equations, by the closed forms that they have at special angles and against double.
#include "kernels/glass.h"

namespace stagelight {
namespace {

using KernelsStage11Fresnel = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage11Fresnel, each_device(), device_name);

const Methods exact{{"fresnel", "exact"}};

TEST_P(KernelsStage11Fresnel, ReflectanceMatchesDouble) {
    reference::Dice dice;
    std::vector<float> cosines, iors;
    for (int i = 0; i < 4096; ++i) {
        cosines.push_back(
            float(i % 4 == 0 ? std::pow(10, dice.between(-6, 0)) : dice.between(0, 1)));
        iors.push_back(float(i % 16 == 0 ? 1 + std::pow(10, dice.between(-6, -1))
                                         : std::pow(4, dice.between(-1, 1))));
    }
    const auto shares = build("optics.cl", with_glass, exact).run<float>("fresnels", cosines, iors);
    Worst share("reflectance");
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double ior = iors[i], denser = std::max(ior, 1 / ior), cosine = cosines[i];
        const double beyond = std::sqrt(1 - (1 - cosine * cosine) / (denser * denser));
        // Grazing, and at indices that are all but equal, the rounding of 1 / ior counts.
        const double sum = cosine + denser * beyond;
        share.compare(i, shares[i], reference::fresnel(1.0, denser, cosine, beyond),
                      8 * ulp + ulp / (sum * sum));
    }
    share.expect(4096);
}

// Head on ((n - 1) / (n + 1))²; grazing, and from inside at the critical angle, all. At Brewster's
// angle, whose tangent is n, what swings within the plane of incidence is not reflected: left is
// half of
// ((n² - 1) / (n² + 1))². Equal indices reflect nothing, and a cosine rounded past its end is no
// NaN.
TEST_P(KernelsStage11Fresnel, SpecialAnglesAreWhatTheClosedFormSays) {
    std::vector<float> cosines, iors, expected;
    const auto add = [&](double cosine, double ior, double share) {
        cosines.push_back(float(cosine));
        iors.push_back(float(ior));
        expected.push_back(float(share));
    };
    for (const double n : {1.01, 1.5, 2.42, 4.0}) {
        for (const double ior : {n, 1 / n}) {
            add(1, ior, std::pow((n - 1) / (n + 1), 2));
            add(0, ior, 1);
            add(1 / std::sqrt(1 + n * n), ior, std::pow((n * n - 1) / (n * n + 1), 2) / 2);
        }
    }
    add(0.5, 1, 0);
    add(1, 1, 0);
    add(0, 1, 1);
    add(1.0000001, 1.5, 0.04);
    add(0.5, 1e18, 1);
    const auto shares = build("optics.cl", with_glass, exact).run<float>("fresnels", cosines, iors);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        EXPECT_NEAR(shares[i], expected[i], 4 * ulp)
            << "cosine " << cosines[i] << ", ior " << iors[i];
    }
}

}  // namespace
}  // namespace stagelight
