// SPDX-License-Identifier: MIT
// The light that comes straight from the lights (docs/shading.md, "Light").
#pragma once

#include "reference/lights.h"
#include "reference/reference.h"
#include "reference/world.h"

namespace stagelight::reference {

// Lambert's, N · L; of Chiang's rule times his shadowing function -G³ + G² + G (Chiang, Li and
// Burley, Taming the Shadow Terminator, SIGGRAPH 2019 Talks, article 71).
template <typename Number>
Number cosine_towards(const Hit<Number> &hit, const Vec<Number> &light, Terminator terminator) {
    const Number cosine = glm::dot(hit.shading_normal, light);
    if (terminator != Terminator::chiang || !(cosine > 0))
        return cosine;
    const Number of_facet = glm::dot(hit.geometric_normal, light);
    const Number between = glm::dot(hit.geometric_normal, hit.shading_normal);
    const Number g = std::clamp(of_facet / (cosine * between), Number(0), Number(1));
    return cosine * (-std::pow(g, Number(3)) + std::pow(g, Number(2)) + g);
}

// Asks for a line to a point light, for a ray towards a directional one.
template <typename Number>
Shadow shadow(const World<Number> &world, const Hit<Number> &hit, const Light &light,
              const Arriving<Number> &arriving, Terminator terminator) {
    // Not a number where the light is at the very point: no light comes from there.
    if (!(cosine_towards(hit, arriving.direction, terminator) > 0)
        || largest(arriving.irradiance) == 0)
        return Shadow::unlit;
    const Ray<Number> ray =
        ray_off_surface(hit.point, hit.geometric_normal, arriving.direction, hit.offset);
    const bool blocked = light.type == LightType::point
                             ? world.blocked(Line<Number>{ray.origin, Vec<Number>(light.position)})
                             : world.blocked(ray);
    return blocked ? Shadow::blocked : Shadow::lit;
}

// Lambert's cosine law, Σ (N · L) E, and to `shadows` one shadow a light.
template <typename Number>
Vec<Number> direct_light(const World<Number> &world, const Hit<Number> &hit,
                         std::vector<Shadow> &shadows, Terminator terminator = Terminator::none) {
    Vec<Number> sum(0);
    for (const Light &light : world.scene().lights) {
        const Arriving<Number> arriving = light_at(light, hit.point);
        shadows.push_back(shadow(world, hit, light, arriving, terminator));
        if (shadows.back() == Shadow::lit)
            sum += cosine_towards(hit, arriving.direction, terminator) * arriving.irradiance;
    }
    return sum;
}

}  // namespace stagelight::reference
