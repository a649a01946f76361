// SPDX-License-Identifier: MIT
// Snell, Schlick and Beer.
#include "kernels/glass.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;

using KernelsStage04Refraction = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage04Refraction, each_device(), device_name);

struct Cases {
    std::vector<vec4> directions, normals;
    std::vector<float> ratios;

    void add(const dvec3 &direction, const dvec3 &normal, double ratio) {
        directions.emplace_back(vec3(direction), 0);
        normals.emplace_back(vec3(normal), 0);
        ratios.push_back(float(ratio));
    }
};

// Indices of 1 to 4, either way; head on, grazing, and around the critical angle.
Cases random_refractions() {
    Dice dice;
    Cases cases;
    for (int i = 0; i < 8192; ++i) {
        const double ior = i % 8 == 0 ? 1 : dice.between(1, 4);
        const double ratio = i % 2 == 0 ? ior : 1 / ior;
        double cosine = dice.between(0, 1);
        if (i % 4 == 1) {
            cosine = std::pow(10, dice.between(-8, 0));
        } else if (i % 4 == 2) {
            const double near_critical = (1 + dice.between(-1e-3, 1e-3)) / ior;
            cosine = std::sqrt(std::max(0.0, 1 - near_critical * near_critical));
        }
        const dvec3 normal = dice.direction();
        cases.add(direction_at(dice, normal, i % 64 == 3 ? 1 : cosine), normal, ratio);
    }
    return cases;
}

TEST_P(KernelsStage04Refraction, DirectionsMatchDoubleAndObeySnell) {
    const Cases cases = random_refractions();
    const auto results = build("optics.cl", with_glass)
                             .run<vec4>("refracted", cases.directions, cases.normals, cases.ratios);
    Worst passes("passes"), direction("direction"), length("length"), sine("sine of the angle"),
        plane("out of the plane of incidence");
    for (std::size_t i = 0; i < results.size(); ++i) {
        const dvec3 d = unit(cases.directions[i]), n = unit(cases.normals[i]), is(results[i]);
        const double ratio = cases.ratios[i];
        const Snell snell(d, n, ratio);
        const auto truth = reference::refract(d, n, ratio, 1.0);
        if (!snell.certain) {
            continue;
        }
        passes.compare(i, results[i].w, truth.has_value(), 0);
        if (truth && results[i].w > 0) {
            direction.compare(i, is, truth->direction,
                              2 * ulp * (1 + ratio) + snell.cosine_rounding);
            length.compare(i, glm::length(is), 1, 2 * ulp);
            // sin₂ = (n₁ / n₂) sin₁, whatever becomes of the cosine.
            sine.compare(i, glm::length(glm::cross(is, n)), ratio * glm::length(glm::cross(d, n)),
                         2 * ulp * (1 + ratio) + snell.rounding);
            plane.compare(i, glm::dot(is, glm::cross(d, n)), 0, 2 * ulp * (1 + ratio));
        }
    }
    passes.expect(8000);
    direction.expect(5000);
    length.expect(5000);
    sine.expect(5000);
    plane.expect(5000);
}

// Inside glass, at a sine of 1e-4 below and above the critical one, 1 / ior.
TEST_P(KernelsStage04Refraction, AllIsReflectedBeyondTheCriticalAngleOnly) {
    Dice dice;
    Cases cases;
    std::vector<bool> expected;
    for (const double ior : {1.001, 1.1, 1.33, 1.5, 2.0, 2.42, 3.0, 4.0}) {
        for (const double beside : {-1e-4, 1e-4}) {
            for (int i = 0; i < 100; ++i) {
                const double sine = (1 + beside) / ior;
                const dvec3 normal = dice.direction();
                cases.add(direction_at(dice, normal, std::sqrt(1 - sine * sine)), normal, ior);
                expected.push_back(beside < 0);
            }
        }
    }
    const auto results = build("optics.cl", with_glass)
                             .run<vec4>("refracted", cases.directions, cases.normals, cases.ratios);
    Worst passes("passes");
    for (std::size_t i = 0; i < results.size(); ++i) {
        passes.compare(i, results[i].w, expected[i], 0);
    }
    passes.expect(1600);
}

TEST_P(KernelsStage04Refraction, EqualIndicesAndTheNormalDoNotBend) {
    Dice dice;
    Cases cases;
    for (int i = 0; i < 1024; ++i) {
        const dvec3 normal = dice.direction();
        const bool head_on = i % 2 == 0;
        const double cosine = head_on ? 1 : dice.between(0.1, 1);
        cases.add(direction_at(dice, normal, cosine), normal, head_on ? dice.between(0.25, 4) : 1);
    }
    const auto results = build("optics.cl", with_glass)
                             .run<vec4>("refracted", cases.directions, cases.normals, cases.ratios);
    Worst direction("direction"), passes("passes");
    for (std::size_t i = 0; i < results.size(); ++i) {
        // Roundings of 4 ulp at most, over the cosine of at least 0.1 (Snell, above).
        direction.compare(i, dvec3(results[i]), unit(cases.directions[i]),
                          (i % 2 == 0 ? 4 * (1 + cases.ratios[i]) : 50) * ulp);
        passes.compare(i, results[i].w, 1, 0);
    }
    passes.expect(1024);
    direction.expect(1024);
}

using KernelsStage04Schlick = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage04Schlick, each_device(), device_name);

TEST_P(KernelsStage04Schlick, ReflectanceMatchesDouble) {
    Dice dice;
    std::vector<float> cosines, iors;
    for (int i = 0; i < 4096; ++i) {
        cosines.push_back(
            float(i % 4 == 0 ? 1 - std::pow(10, dice.between(-7, 0)) : dice.between(0, 1)));
        iors.push_back(float(i % 16 == 0 ? 1 : std::pow(4, dice.between(-1, 1))));
    }
    const auto shares = build("optics.cl", with_glass).run<float>("fresnels", cosines, iors);
    Worst share("reflectance");
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double expected = reference::schlick<double>(1, iors[i], cosines[i], cosines[i]);
        // Sums of what is positive, and products: each of about ten adds half an ulp.
        share.compare(i, shares[i], expected, 4 * ulp * expected);
    }
    share.expect(4096);
}

// Head on F₀, of 1.5 (0.5 / 2.5)² = 0.04; grazing all; a cosine that was rounded past 1 is no NaN.
TEST_P(KernelsStage04Schlick, NastyCosinesAreWhatTheClosedFormSays) {
    const std::vector<float> cosines{1, 1, 1, 0, 0, 1.0000001F, 0},
        iors{1.5F, 1, 4, 1.5F, 1, 1.5F, 1e18F};
    const std::vector<float> expected{0.04F, 0, 0.36F, 1, 1, 0.04F, 1};
    const auto shares = build("optics.cl", with_glass).run<float>("fresnels", cosines, iors);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        EXPECT_FLOAT_EQ(shares[i], expected[i]) << "cosine " << cosines[i] << ", ior " << iors[i];
    }
}

// At any angle: head on, aslant and grazing, from either side.
TEST_P(KernelsStage04Schlick, WithoutFresnelNothingIsReflected) {
    const std::vector<float> cosines{1, 0.5F, 0, 1, 0.5F, 0},
        iors{1.5F, 1.5F, 1.5F, 1 / 1.5F, 1 / 1.5F, 1 / 1.5F};
    EXPECT_EQ(
        build("optics.cl", with_glass, {{"fresnel", "none"}}).run<float>("fresnels", cosines, iors),
        std::vector<float>(6, 0));
}

using KernelsStage04Beer = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage04Beer, each_device(), device_name);

TEST_P(KernelsStage04Beer, TransmittanceMatchesDouble) {
    Dice dice;
    std::vector<vec4> absorptions;
    std::vector<float> distances;
    for (int i = 0; i < 4096; ++i) {
        absorptions.emplace_back(std::pow(10, dice.between(-4, 1)), dice.between(0, 3), 0, 0);
        distances.push_back(i == 0 ? 0 : float(std::pow(10, dice.between(-6, 4))));
    }
    const auto shares =
        build("optics.cl", with_glass).run<vec4>("transmittances", absorptions, distances);
    Worst share("transmittance"), nothing("transmittance where nothing absorbs");
    for (std::size_t i = 0; i < shares.size(); ++i) {
        for (const int channel : {0, 1}) {
            const double exponent = double(absorptions[i][channel]) * double(distances[i]);
            // OpenCL C's exp, 3 ulp, and the product's rounding, which it blows up; what
            // float can't hold may become 0.
            const double expected = std::exp(-exponent);
            share.compare(i, shares[i][channel], expected,
                          (3 + exponent) * ulp * expected + 1.2e-38);
        }
        nothing.compare(i, shares[i].z, 1, 0);
    }
    share.expect(8192);
    nothing.expect(4096);
}

TEST_P(KernelsStage04Beer, NothingIsLeftAtInfinity) {
    const std::vector<vec4> absorptions{{1e-4, 1, 1e4, 0}, {1e18, 1e18, 1e18, 0}};
    const auto shares =
        build("optics.cl", with_glass)
            .run<vec4>("transmittances", absorptions, std::vector<float>{INFINITY, 1e30F});
    EXPECT_EQ(shares[0], vec4(0));
    EXPECT_EQ(shares[1], vec4(0)) << "the product overflows";
}

}  // namespace
}  // namespace stagelight
