// SPDX-License-Identifier: MIT
// The paper's way through the inside of a glass sphere: in, absorbed, out.
#include "kernels/glass_spheres.h"

namespace stagelight {
namespace {

using reference::Dice;

using KernelsStage04InteriorPaper = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage04InteriorPaper, each_device(), device_name);

// From a point on a sphere, anywhere and of any size, the chord ends on the sphere again.
TEST_P(KernelsStage04InteriorPaper, ARayInsideASphereEndsOnItsFarWall) {
    Dice dice;
    std::vector<vec4> origins, directions, centers;
    for (int i = 0; i < 4096; ++i) {
        const double radius = std::pow(10, dice.between(-6, 6));
        const dvec3 center(vec3(radius * dice.in_cube(100))), outward = dice.direction();
        const double cosine = i % 4 == 0 ? std::pow(10, dice.between(-6, 0)) : dice.between(0, 1);
        origins.emplace_back(vec3(center + radius * outward), 0);
        directions.emplace_back(vec3(direction_at(dice, outward, cosine)), 0);
        centers.emplace_back(vec3(center), 0);
    }
    const auto chords = build("optics.cl", with_glass, interior_paper)
                            .run<float>("chords", origins, directions, centers);
    Worst far_wall("distance of the far wall");
    for (std::size_t i = 0; i < chords.size(); ++i) {
        const dvec3 from_center = dvec3(origins[i]) - dvec3(centers[i]);
        const double truth = -2 * glm::dot(from_center, unit(directions[i]));
        far_wall.compare(i, chords[i], truth, 4 * ulp * glm::length(from_center));
    }
    far_wall.expect(4096);
}

// In the plane of incidence, of N and the tangent τ, a ray at the angle θ₁ goes in at θ₂, meets the
// far wall where its normal is sin 2θ₂ τ - cos 2θ₂ N, after 2 r cos θ₂, and leaves along
// sin(2θ₂ - θ₁) τ - cos(2θ₂ - θ₁) N: each wall turns it by θ₁ - θ₂.
struct Passage {
    dvec3 exit, direction;
    double chord;

    Passage(const GlassSpheres &cases, std::size_t i) {
        const dvec3 d = unit(cases.directions[i]), n = unit(cases.normals[i]);
        const double radius = cases.spheres[i].w, cosine = -glm::dot(d, n);
        const dvec3 tangent = glm::normalize(d + cosine * n);
        const double in = std::acos(cosine), inside = std::asin(std::sin(in) / cases.ior(i));
        const double out = 2 * inside - in;
        chord = 2 * radius * std::cos(inside);
        exit = dvec3(cases.spheres[i])
               + radius * (std::sin(2 * inside) * tangent - std::cos(2 * inside) * n);
        direction = std::sin(out) * tangent - std::cos(out) * n;
    }
};

TEST_P(KernelsStage04InteriorPaper, RaysLeaveByTheClosedForm) {
    const GlassSpheres cases;
    const auto results = spawn(build("optics.cl", with_glass, interior_paper), cases);
    RayComparison reflected("reflected"), left("let out");
    Worst exit("exit"), side("starts outside"), counted("ray counts");
    for (std::size_t i = 0; i < results.size(); i += 2) {  // those from outside
        const Truth truth(cases, i);
        const Passage passage(cases, i);
        const dvec3 d = unit(cases.directions[i]), n = unit(cases.normals[i]);
        const dvec3 center(cases.spheres[i]);
        const double radius = cases.spheres[i].w, size = radius + reference::largest(center);
        const auto &[reflection, leaving] = results[i].rays;
        ASSERT_TRUE(reflection.exists() && leaving.exists()) << "case " << i;
        counted.compare(i, dvec3(results[i].counts), {1, 1, 0}, 0);
        reflected.compare(i, reflection, truth.reflectance, truth.reflectance_rounding,
                          reference::reflect(d, n, n), 8 * ulp, same_medium);
        // The exponent is at most 4, and its chord off by some roundings. Where the ray leaves
        // in a grazing way its angle is the root of a difference, and the point's rounding shows.
        left.compare(i, leaving,
                     (1 - truth.reflectance)
                         * std::exp(-double(cases.absorptions[i].x) * passage.chord),
                     truth.reflectance_rounding + 16 * ulp, passage.direction,
                     8 * ulp * cases.ior(i) * size / radius / -glm::dot(d, n), air);
        // It starts 1e-5 radii off the wall (spawn in optics.cl).
        exit.compare(i, dvec3(leaving.origin), passage.exit, 1e-5 * radius + 8 * ulp * size);
        side.compare(i, glm::distance(dvec3(leaving.origin), center) > radius, true, 0);
    }
    reflected.expect(2048);
    left.expect(2048);
    exit.expect(2048);
    side.expect(2048);
    counted.expect(2048);
}

// "A hit from behind (the eye inside the sphere) refracts out, once, F and inner reflection left
// out."
TEST_P(KernelsStage04InteriorPaper, RaysFromInsideAreRefractedOut) {
    const GlassSpheres cases;
    const auto results = spawn(build("optics.cl", with_glass, interior_paper), cases);
    RayComparison left("let out");
    Worst counted("ray counts");
    for (std::size_t i = 1; i < results.size(); i += 2) {
        const Truth truth(cases, i);
        if (truth.certain) {
            counted.compare(i, dvec3(results[i].counts), {0, truth.refraction.has_value(), 0}, 0);
        }
        if (truth.certain && truth.refraction) {
            left.compare(i, results[i].rays[0], 1, 0, truth.refraction->direction,
                         truth.direction_rounding, air);
        }
    }
    left.expect(250);
    counted.expect(2000);
}

}  // namespace
}  // namespace stagelight
