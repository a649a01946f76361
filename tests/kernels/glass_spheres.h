// SPDX-License-Identifier: MIT
// Rays that meet spheres of glass, and the rays that they spawn there.
#pragma once

#include "kernels/glass.h"

namespace stagelight {

using glm::dvec3, glm::vec3, glm::vec4;

// From outside and from inside.
struct GlassSpheres {
    std::vector<vec4> directions, normals, points, media, spheres, absorptions;
    std::vector<glm::vec2> iors;  // and whether from behind

    GlassSpheres() {
        reference::Dice dice;
        for (int i = 0; i < 4096; ++i) {
            const double radius = std::pow(10, dice.between(-3, 3));
            const vec3 center(radius * dice.in_cube(2));
            const dvec3 normal = dice.direction();
            const bool behind = i % 2 == 1;
            const auto ior = float(dice.between(1.05, 4));
            directions.emplace_back(vec3(direction_at(dice, normal, dice.between(0.02, 1))), 0);
            normals.emplace_back(vec3(normal), 0);
            points.emplace_back(vec3(dvec3(center) + (behind ? -radius : radius) * normal), 0);
            media.emplace_back(ior, behind, 0, 0);
            iors.emplace_back(ior, behind);
            spheres.emplace_back(center, radius);
            absorptions.emplace_back(
                vec3(dvec3(dice.between(0, 2), dice.between(0, 1), 0) / radius), 0);
        }
    }
    bool behind(std::size_t i) const { return iors[i].y > 0; }
    double ior(std::size_t i) const { return double(iors[i].x); }
};

// What docs/shading.md ("Dielectrics") says of one case, in double.
struct Truth {
    double n1, n2, reflectance, direction_rounding, reflectance_rounding;
    std::optional<reference::Refraction<double>> refraction;
    bool certain;

    Truth(const GlassSpheres &cases, std::size_t i)
        : n1(cases.behind(i) ? cases.ior(i) : 1), n2(cases.behind(i) ? 1 : cases.ior(i)) {
        const dvec3 d = unit(cases.directions[i]), n = unit(cases.normals[i]);
        const Snell snell(d, n, n1 / n2);
        refraction = reference::refract(d, n, n1, n2);
        reflectance =
            refraction ? reference::schlick(n1, n2, -glm::dot(d, n), refraction->cosine) : 1;
        direction_rounding = 2 * ulp * (1 + n1 / n2) + snell.cosine_rounding;
        reflectance_rounding = 4 * ulp + 5 * direction_rounding;  // the slope of (1 - cos)⁵
        certain = snell.certain;
    }
};

// Structs of optics.cl.
struct SpawnedRay {
    vec4 origin, direction, weight, absorption;

    bool exists() const { return absorption.w > 0; }
};
struct Spawned {
    SpawnedRay rays[2];
    glm::uvec4 counts;  // reflection, refraction, dropped
};

// Media by what they absorb; that of all rays that come is spawn's in optics.cl.
inline const dvec3 air(0), same_medium(0.5);

inline std::vector<Spawned> spawn(DeviceProgram program, const GlassSpheres &cases) {
    return program.run<Spawned>("spawn", cases.directions, cases.normals, cases.points, cases.media,
                                cases.spheres, cases.absorptions);
}

// All that a spawned ray has but its origin.
class RayComparison {
public:
    explicit RayComparison(const std::string &what)
        : share_("share that is " + what), direction_("direction of what is " + what),
          depth_("depth of what is " + what), medium_("absorption of what is " + what) {}

    void compare(std::size_t i, const SpawnedRay &ray, double share, double share_rounding,
                 const dvec3 &direction, double direction_rounding, const dvec3 &medium) {
        share_.compare(i, ray.weight.x, share, share_rounding);
        direction_.compare(i, dvec3(ray.direction), direction, direction_rounding);
        depth_.compare(i, ray.weight.w, 1, 0);
        medium_.compare(i, dvec3(ray.absorption), medium, 0);
    }
    void expect(std::size_t least) const {
        for (const Worst *worst : {&share_, &direction_, &depth_, &medium_}) {
            worst->expect(least);
        }
    }

private:
    Worst share_, direction_, depth_, medium_;
};

}  // namespace stagelight
