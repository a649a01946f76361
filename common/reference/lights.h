// SPDX-License-Identifier: MIT
// Point and directional lights.
#pragma once

#include "reference/rays.h"
#include "scene/scene.h"

namespace stagelight::reference {

// A light as a point of a surface gets it, if nothing stands in the way.
template <typename Number> struct Arriving {
    Vec<Number> direction;   // to the light, unit length
    Vec<Number> irradiance;  // on a surface that faces it
};

// Lets a light's reach end smoothly (Karis, Real Shading in Unreal Engine 4, 2013).
template <typename Number> Number range_window(Number distance, Number range) {
    const Number share = distance / range;
    const Number left = std::max(Number(0), 1 - share * share * share * share);
    return left * left;
}

template <typename Number> Arriving<Number> light_at(const Light &light, const Vec<Number> &point) {
    const Vec<Number> power = Vec<Number>(light.color) * Number(light.intensity);
    if (light.type == LightType::directional)
        return {-Vec<Number>(light.direction), power};
    const Vec<Number> way = Vec<Number>(light.position) - point;
    const Number distance = glm::length(way);
    return {way / distance,
            power * range_window(distance, Number(light.range)) / (distance * distance)};
}

}  // namespace stagelight::reference
