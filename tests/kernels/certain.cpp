// SPDX-License-Identifier: MIT
#include "kernels/certain.h"

#include <algorithm>

namespace stagelight {
namespace {

using glm::dvec3, glm::vec3;
using reference::Dice, reference::Shadow;

const std::vector<dvec3> &steps_aside() {
    static const std::vector<dvec3> all = [] {
        Dice dice;
        std::vector<dvec3> steps;
        for (int i = 0; i < 8; ++i) {
            steps.push_back(margin * dice.direction());
        }
        return steps;
    }();
    return all;
}

Ray moved(const Ray &ray, const dvec3 &step) {
    return {ray.origin + step, ray.direction};
}

// Its ends move in different directions.
Line moved(const Line &line, const dvec3 &step) {
    return {line.origin + step, line.destination - dvec3(step.y, step.z, step.x)};
}

template <typename Way> std::optional<bool> same_for_all(const World &world, const Way &way) {
    const bool blocked = world.blocked(way);
    const bool certain = std::ranges::all_of(steps_aside(), [&](const dvec3 &step) {
        return world.blocked(moved(way, step)) == blocked;
    });
    return certain ? std::optional(blocked) : std::nullopt;
}

}  // namespace

RandomWays::RandomWays(Dice &dice, Kind kind) {
    for (int i = 0; i < 1024; ++i) {
        origins.emplace_back(vec3(dice.in_cube(5)), 0);
        ends.emplace_back(vec3(kind == lines ? dice.in_cube(5) : dice.direction()), 0);
    }
}

std::vector<Hit> certain_hits(const World &world, const Ray &ray) {
    std::vector<Hit> hits;
    const auto meets = [&](const Ray &it) {
        const auto hit = world.closest_hit(it);
        if (hit) {
            hits.push_back(*hit);
        }
        return hit && hit->material == hits[0].material && hit->from_behind == hits[0].from_behind;
    };
    const bool all = meets(ray) && std::ranges::all_of(steps_aside(), [&](const dvec3 &step) {
                         return meets(moved(ray, step));
                     });
    return all ? hits : std::vector<Hit>();
}

std::optional<bool> certainly_blocked(const World &world, const Ray &ray) {
    return same_for_all(world, ray);
}

std::optional<bool> certainly_blocked(const World &world, const Line &line) {
    return same_for_all(world, line);
}

std::optional<Lit> certain_light(const World &world, const std::vector<Hit> &hits) {
    std::vector<Shadow> first;
    const dvec3 sum = reference::direct_light(world, hits[0], first);
    double spread = 0;
    for (const Hit &hit : hits) {
        std::vector<Shadow> shadows;
        const dvec3 its = reference::direct_light(world, hit, shadows);
        spread = std::max(spread, glm::distance(its, sum));
        if (shadows != first) {
            return std::nullopt;
        }
    }
    int shadow_rays = 0;
    for (const Light &light : world.scene().lights) {
        shadow_rays +=
            glm::dot(hits[0].shading_normal, reference::light_at(light, hits[0].point).direction)
            > 0;
    }
    return Lit{sum, share_of_spread * spread + 16 * ulp * glm::length(sum), shadow_rays};
}

}  // namespace stagelight
