// SPDX-License-Identifier: MIT
// Refraction in closed meshes: flat facets by Snell, Fresnel and Beer, and smooth ones near their
// rims.
#include "reference/glass_slab.h"

namespace stagelight::reference {
namespace {

TEST(ReferenceStage11Glass, ASlabBendsSplitsAndAbsorbs) {
    for (const double angle : {0.0, 0.4, 0.9, 1.3}) {
        const GlassSlab slab{.angle = angle};
        const auto along = ray(slab.eye(), slab.direction());
        expect_near(seen(slab.scene(), along), slab.seen(schlick_at(angle, slab.ior)), 1e-12);
        expect_near(seen(slab.scene(), along, {.fresnel = Fresnel::exact}),
                    slab.seen(fresnel_at(angle, slab.ior)), 1e-12);
    }
}

TEST(ReferenceStage11Fresnel, IsTheClosedFormAtSpecialAngles) {
    for (const double n : {1.01, 1.5, 2.42}) {
        EXPECT_NEAR(fresnel(1.0, n, 1.0, 1.0), std::pow((n - 1) / (n + 1), 2), 1e-15);
        EXPECT_EQ(fresnel(1.0, n, 0.0, std::sqrt(1 - 1 / (n * n))), 1) << "grazing";
        EXPECT_EQ(fresnel(n, 1.0, std::sqrt(1 - 1 / (n * n)), 0.0), 1) << "critical";
        // At Brewster's angle the ways of what is reflected and what is transmitted stand at right
        // angles, and nothing that swings within the plane is reflected.
        const double brewster = std::atan(n), inner = std::numbers::pi / 2 - brewster;
        const double across = std::pow((n * n - 1) / (n * n + 1), 2);
        EXPECT_NEAR(fresnel(1.0, n, std::cos(brewster), std::cos(inner)), across / 2, 1e-15);
        EXPECT_NEAR(fresnel(n, 1.0, std::cos(inner), std::cos(brewster)), across / 2, 1e-15);
    }
    EXPECT_EQ(fresnel(1.0, 1.0, 0.5, 0.5), 0);
    EXPECT_EQ(fresnel(1.0, 1.0, 0.0, 0.0), 1);
}

// Twice as fine a mesh is nearer to the sphere: its facets by four, its rim by two.
TEST(ReferenceStage11Glass, AFinerBallIsNearerToTheSphere) {
    const Settings settings{.width = 48, .height = 48};
    const auto truth = render<double>(glass_ball(), settings).image.pixels;
    double before = 0.01;
    for (const int n : {16, 32, 64}) {
        const auto mesh = render<double>(glass_ball(n), settings).image.pixels;
        const double difference = mean_difference(mesh, truth);
        EXPECT_LT(difference, before / 2) << n;
        before = difference;
    }
    EXPECT_LT(before, 5e-4);
}

// G is up, and N leans by 60 degrees to +x: at 30 degrees from G the ray runs at right angles to N.
// On the way there what is transmitted fades, and beyond nothing is, from either side.
TEST(ReferenceStage11Smooth, ANormalTurnedAwayReflectsAll) {
    const dvec3 n(std::sqrt(0.75), 0.5, 0);
    for (const double index : {1.01, 1.5, 0.7}) {
        Scene scene;
        add_triangle(scene, {{-1, 0, 1}, n, {}}, {{1, 0, 1}, n, {}}, {{0, 0, -2}, n, {}},
                     add_material(scene, glass({1, 1, 1}, index, {})));
        for (const double side : {1.0, -1.0}) {
            const auto at = [&](double angle) {
                const dvec3 way = side * dvec3(std::sin(angle), -std::cos(angle), 0);
                return met(scene, ray(-way, way));
            };
            const double along = glm::radians(30.0);
            EXPECT_EQ(at(along + 1e-6).children.size(), 1u) << index << " from " << side;
            EXPECT_EQ(at(along + 0.5).children.size(), 1u) << index << " from " << side;
            const RayTree before = at(along - 1e-6);
            ASSERT_GE(before.children.size(), 1u);
            if (before.children.size() > 1) {
                EXPECT_LT(before.children[1].weight, 1e-4) << index << " from " << side;
            }
            EXPECT_NEAR(before.children[0].weight, 1, 1e-4) << index << " from " << side;
        }
    }
}

// What leaves glass by a leaning normal may come out above the facet: it is mirrored beneath.
TEST(ReferenceStage11Smooth, WhatIsTransmittedGoesBeneathTheFacet) {
    const dvec3 g(0, 1, 0);
    expect_near(beneath(dvec3(0.6, 0.8, 0), g), {0.6, -0.8, 0}, 1e-15);
    expect_near(beneath(dvec3(0.6, -0.8, 0), g), {0.6, -0.8, 0}, 0);
    expect_near(beneath(dvec3(1, 0, 0), g), {1, 0, 0}, 0);
}

}  // namespace
}  // namespace stagelight::reference
