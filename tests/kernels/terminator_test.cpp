// SPDX-License-Identifier: MIT
// Where light ends on smooth meshes: how far shadow rays are lifted, and how much light fades.
#include <array>
#include <cmath>

#include "kernels/on_device.h"
#include "kernels/worst.h"
#include "reference/hit.h"
#include "reference/scenes.h"
#include "scene_types.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;

using KernelsStage11Terminator = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage11Terminator, each_device(), device_name);

const SceneNeeds with_smooth_mesh{{"HAS_TRIANGLES", 1}, {"HAS_SMOOTH_MESH", 1}};

device::float4 to_device(const vec3 &v) {
    return {{v.x, v.y, v.z, 0}};
}

// Facets that are seen from both sides, with normals that lean by any angle: the mesh is above
// them, beneath them, or above one corner and beneath another.
struct LeaningFacets {
    std::vector<vec4> weights, directions;
    std::vector<device::Triangle> triangles;
    std::vector<std::array<device::float4, 3>> corners, normals;
    Scene scene;  // the same, as the reference has it

    LeaningFacets() {
        Dice dice;
        for (int i = 0; i < 8192; ++i) {
            const dvec3 middle = dice.in_cube(10), up = dice.direction();
            const double lean = i % 4 == 0 ? dice.between(0, 2) : dice.between(0, 0.5);
            const auto first = std::uint32_t(3 * corners.size());
            triangles.push_back({{first, first + 1, first + 2}, 0});
            scene.triangles.push_back({.vertices = {first, first + 1, first + 2}});
            auto &at = corners.emplace_back(), &toward = normals.emplace_back();
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const vec3 position(middle + glm::cross(up, dice.in_cube(1)));
                const vec3 normal(glm::normalize(up + lean * dice.direction()));
                at[corner] = to_device(position);
                toward[corner] = to_device(normal);
                scene.vertices.push_back({position, normal, {}});
            }
            const double b = dice.between(0, 1);
            weights.emplace_back(b, dice.between(0, 1 - b), 0, 0);
            directions.emplace_back(vec3(dice.direction()), 0);
        }
    }

    // Seen by that ray, and its normals turned to the eye.
    reference::Hit<double> hit(std::size_t i) const {
        return reference::turned_to_eye(
            reference::triangle_hit<double>(scene, scene.triangles[i],
                                            {1, weights[i].x, weights[i].y}),
            dvec3(directions[i]));
    }
};

// Positions of up to 10 are rounded, and so is what is left of them. A side that hangs on less than
// that is not asked for.
TEST_P(KernelsStage11Terminator, LiftsMatchDouble) {
    const LeaningFacets cases;
    const auto lifts = build("terminator.cl", with_smooth_mesh, {{"terminator", "hanika"}})
                           .run<vec4>("lifts", cases.weights, cases.directions, cases.triangles,
                                      cases.corners, cases.normals);
    Worst lift("lift");
    std::size_t lifted = 0, from_behind = 0, stays = 0;
    for (std::size_t i = 0; i < lifts.size(); ++i) {
        const reference::Hit<double> hit = cases.hit(i);
        const double turn = glm::dot(hit.geometric_normal, dvec3(cases.directions[i]));
        const double lean = glm::dot(hit.geometric_normal, hit.shading_normal);
        const double height = glm::dot(hit.rise, hit.geometric_normal);
        if (std::min({std::abs(turn), lean, height > 0 ? height : 1}) < 1e-3) {
            continue;
        }
        lift.compare(i, dvec3(lifts[i]), hit.rise, 64 * ulp);
        lifted += height > 0;
        from_behind += height > 0 && hit.from_behind;
        stays += height == 0;
    }
    lift.expect(7000);
    EXPECT_GT(lifted, 3000u);
    EXPECT_GT(from_behind, 1000u);
    EXPECT_GT(stays, 300u);
}

// On a roof over the x axis whose normals lean out by `angle`, the centroid is (sin angle) beneath
// the planes of both ends of the ridge, which are a third each: up by 2/3 sin cos. Seen from
// beneath it is in a hollow, and the other way round where normals lean in.
TEST_P(KernelsStage11Terminator, LiftOfARoofIsWhatTheClosedFormSays) {
    const double angle = 0.3, lift = std::sin(2 * angle) / 3;
    struct Case {
        double lean, from;
        dvec3 expected;
    };
    std::vector<vec4> weights, directions;
    std::vector<device::Triangle> triangles;
    std::vector<std::array<device::float4, 3>> corners, normals;
    const std::vector<Case> list{{angle, 1, {0, lift, 0}},
                                 {angle, -1, {0, 0, 0}},
                                 {-angle, 1, {0, 0, 0}},
                                 {-angle, -1, {0, -lift, 0}},
                                 {0, 1, {0, 0, 0}}};
    for (const Case &each : list) {
        const auto first = std::uint32_t(3 * corners.size());
        const dvec3 right(std::sin(each.lean), std::cos(each.lean), 0);
        const dvec3 left(-right.x, right.y, 0);
        triangles.push_back({{first, first + 1, first + 2}, 0});
        corners.push_back({to_device({-1, 0, -1}), to_device({1, 0, -1}), to_device({0, 0, 2})});
        normals.push_back({to_device(left), to_device(right), to_device({0, 1, 0})});
        weights.emplace_back(1 / 3.0, 1 / 3.0, 0, 0);
        directions.emplace_back(0, -each.from, 0, 0);
    }
    const auto lifts = build("terminator.cl", with_smooth_mesh, {{"terminator", "hanika"}})
                           .run<vec4>("lifts", weights, directions, triangles, corners, normals);
    for (std::size_t i = 0; i < list.size(); ++i) {
        SCOPED_TRACE(i);
        reference::expect_near(dvec3(lifts[i]), list[i].expected, 4 * ulp);
    }
}

struct Lit {
    std::vector<vec4> facets, normals, directions;

    void add(const dvec3 &facet, const dvec3 &normal, const dvec3 &direction) {
        facets.emplace_back(vec3(facet), 0);
        normals.emplace_back(vec3(normal), 0);
        directions.emplace_back(vec3(direction), 0);
    }
};

class Shadowings : public OnDevice {
protected:
    // For one ray, and for many side by side.
    static std::array<std::vector<float>, 2> of(const Lit &cases, const char *method) {
        SceneNeeds wide = with_smooth_mesh;
        wide.emplace_back("WIDTH", 4);
        const Methods methods{{"terminator", method}};
        const auto run = [&](DeviceProgram program) {
            return program.run<float>("shadowings", cases.facets, cases.normals, cases.directions);
        };
        return {run(build("terminator.cl", with_smooth_mesh, methods)),
                run(build("packet_terminator.cl", wide, methods))};
    }
};
using KernelsStage11Shadowing = Shadowings;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage11Shadowing, each_device(), device_name);

// What is unshadowed is off by some roundings, and G by as much, relative to that.
TEST_P(KernelsStage11Shadowing, OfChiangMatchesDouble) {
    Dice dice;
    Lit cases;
    for (int i = 0; i < 8192; ++i) {
        const dvec3 facet = dice.direction();
        cases.add(facet, glm::normalize(facet + dice.between(0, 0.95) * dice.direction()),
                  dice.direction());
    }
    for (const std::vector<float> &shares : of(cases, "chiang")) {
        Worst share("share of the light");
        std::size_t faded = 0;
        for (std::size_t i = 0; i < shares.size(); ++i) {
            const dvec3 g(cases.facets[i]), s(cases.normals[i]), light(cases.directions[i]);
            const double unshadowed = glm::dot(s, light) * glm::dot(g, s);
            if (glm::dot(s, light) < 1e-3) {
                continue;  // asked for where the light is above the horizon
            }
            const double G = std::clamp(glm::dot(g, light) / unshadowed, 0.0, 1.0);
            share.compare(i, shares[i], -G * G * G + G * G + G, 8 * ulp / unshadowed);
            faded += G > 0 && G < 1;
        }
        share.expect(4000);
        EXPECT_GT(faded, 1000u);
    }
}

// The light at 60 degrees from the facet's normal, the shading normal at 45, both in one plane:
// cos 60 / (cos 15 cos 45) is sqrt 3 - 1, and the share 13 - 7 sqrt 3. Head on all of it, and along
// the facet none. Hanika's rule takes nothing away.
TEST_P(KernelsStage11Shadowing, IsWhatTheClosedFormSays) {
    const auto at = [](double degrees) {
        return dvec3(std::sin(glm::radians(degrees)), std::cos(glm::radians(degrees)), 0);
    };
    Lit cases;
    cases.add({0, 1, 0}, at(45), at(60));
    cases.add({0, 1, 0}, at(45), at(0));
    cases.add({0, 1, 0}, at(45), at(100));
    cases.add({0, 1, 0}, at(0), at(80));
    const std::vector<double> expected{13 - 7 * std::sqrt(3), 1, 0, 1};
    for (const std::vector<float> &shares : of(cases, "chiang")) {
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_NEAR(shares[i], expected[i], 8 * ulp) << i;
        }
    }
    for (const std::vector<float> &shares : of(cases, "hanika")) {
        for (const float share : shares) {
            EXPECT_EQ(share, 1);
        }
    }
}

}  // namespace
}  // namespace stagelight
