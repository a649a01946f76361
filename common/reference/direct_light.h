// SPDX-License-Identifier: MIT
// The light that comes straight from the lights (docs/shading.md, "Light").
#pragma once

#include "reference/lights.h"
#include "reference/world.h"

namespace stagelight::reference {

// Asks for a line to a point light, for a ray towards a directional one.
template <typename Number>
Shadow shadow(const World<Number> &world, const Hit<Number> &hit, const Light &light,
              const Arriving<Number> &arriving) {
    // Not a number where the light is at the very point: no light comes from there.
    if (!(glm::dot(hit.shading_normal, arriving.direction) > 0)
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
                         std::vector<Shadow> &shadows) {
    Vec<Number> sum(0);
    for (const Light &light : world.scene().lights) {
        const Arriving<Number> arriving = light_at(light, hit.point);
        shadows.push_back(shadow(world, hit, light, arriving));
        if (shadows.back() == Shadow::lit)
            sum += glm::dot(hit.shading_normal, arriving.direction) * arriving.irradiance;
    }
    return sum;
}

}  // namespace stagelight::reference
