// SPDX-License-Identifier: MIT
// Where light ends on smooth meshes, by each rule.
#include "scenes.h"

namespace stagelight::reference {
namespace {

// A facet of a roof over the x axis, in the plane y = 0, whose normals lean out by `angle` at its
// ends; negative, in. The ray that comes down to its centroid, from above or from below.
Hit<double> centroid_of_roof(double angle, double from) {
    Scene scene;
    const dvec3 right(std::sin(angle), std::cos(angle), 0), left(-right.x, right.y, 0);
    add_material(scene, diffuse({1, 1, 1}));
    add_triangle(scene, {{-1, 0, -1}, left, {}}, {{1, 0, -1}, right, {}},
                 {{0, 0, 2}, {0, 1, 0}, {}});
    return World<double>(scene).closest_hit(ray({0, from, 0}, {0, -from, 0})).value();
}

// The centroid is sin(angle) beneath the tangent planes of both ends, each a third of the blend:
// up by 2/3 sin cos. From the other side it is a hollow, and the facet itself.
TEST(ReferenceStage11Terminator, ARoofRisesToItsTangentPlanes) {
    for (const double angle : {0.1, 0.3, 0.7}) {
        const dvec3 rise(0, std::sin(2 * angle) / 3, 0);
        expect_near(centroid_of_roof(angle, 1).rise, rise, 1e-15);
        expect_near(centroid_of_roof(angle, -1).rise, {0, 0, 0}, 0);
        expect_near(centroid_of_roof(-angle, 1).rise, {0, 0, 0}, 0);
        expect_near(centroid_of_roof(-angle, -1).rise, -rise, 1e-15);
    }
}

// A facet in the plane y = 0 with one normal, which leans by 45 degrees, under light at `degrees`
// from the facet's own.
dvec3 leaning(double degrees, Terminator terminator) {
    Scene scene;
    const dvec3 normal = glm::normalize(dvec3(1, 1, 0));
    add_material(scene, diffuse({1, 1, 1}));
    add_triangle(scene, {{-1, 0, -1}, normal, {}}, {{1, 0, -1}, normal, {}},
                 {{0, 0, 2}, normal, {}});
    const double angle = glm::radians(degrees);
    add_directional_light(scene, {-std::sin(angle), -std::cos(angle), 0}, {1, 1, 1}, 1);
    return seen(scene, ray({0, 1, 0}, {0, -1, 0}), {.terminator = terminator});
}

// At 60 degrees G is cos 60 / (cos 15 cos 45) = sqrt 3 - 1, and the share of it 13 - 7 sqrt 3. From
// the facet's normal to the shading normal's other side all of it is there; along the facet nothing
// is, without a step.
TEST(ReferenceStage11Terminator, ChiangFadesLightAlongTheFacet) {
    const double cos15 = std::cos(glm::radians(15.0));
    expect_near(leaning(60, Terminator::chiang), dvec3(cos15 * (13 - 7 * std::sqrt(3.0))), 1e-14);
    expect_near(leaning(60, Terminator::none), dvec3(cos15), 1e-14);
    expect_near(leaning(0, Terminator::chiang), dvec3(std::sqrt(0.5)), 1e-14);
    expect_near(leaning(89.999, Terminator::chiang), dvec3(0), 5e-5);
    EXPECT_GT(leaning(89.999, Terminator::none).x, 0.7);
    expect_near(leaning(91, Terminator::chiang), dvec3(0), 0);
}

// A ball of facets is lit as its normals are by Hanika's rule, and seen from within as ever.
TEST(ReferenceStage11Terminator, HanikaLightsABallOfFacets) {
    Dice dice;
    Scene scene;
    add_ball(scene, {0, 0, 0}, 1, 6, add_material(scene, diffuse({1, 1, 1})));
    add_directional_light(scene, dice.direction(), {1, 1, 1}, 1);
    int black = 0;
    for (int i = 0; i < 800; ++i) {
        const dvec3 direction = dice.direction();
        const auto along = ray(-3.0 * direction + dice.in_cube(0.6), direction);
        const RayTree hit = met(scene, along);
        if (hit.surface.kind == Surface::Kind::none)
            continue;
        const double lambert =
            std::max(0.0, -glm::dot(hit.shading_normal, scene.lights[0].direction));
        expect_near(seen(scene, along, {.terminator = Terminator::hanika}), dvec3(lambert), 1e-14);
        black += lambert > 0.01 && seen(scene, along) == dvec3(0);
        const auto within = ray(dice.in_cube(0.3), direction);
        EXPECT_EQ(seen(scene, within, {.terminator = Terminator::hanika}), seen(scene, within));
    }
    EXPECT_GT(black, 10);
}

}  // namespace
}  // namespace stagelight::reference
