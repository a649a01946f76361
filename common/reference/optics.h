// SPDX-License-Identifier: MIT
// What a surface does to a ray (paper, sections 4 and 5). Directions and normals have unit
// length, and geometric normals face the ray: d · g < 0. So do shading normals, but for those of
// smooth meshes near their rims.
#pragma once

#include <optional>

#include "reference/rays.h"

namespace stagelight::reference {

// The mirrored direction. The shading normal of a smooth mesh may send it beneath the facet
// whose own normal is `geometric`: then it is folded back (docs/shading.md, "Materials").
template <typename Number>
Vec<Number> reflect(const Vec<Number> &d, const Vec<Number> &normal, const Vec<Number> &geometric) {
    const Vec<Number> r = d - 2 * glm::dot(d, normal) * normal;
    const Number depth = glm::dot(r, geometric);
    return depth < 0 ? r - 2 * depth * geometric : r;
}

template <typename Number> struct Refraction {
    Vec<Number> direction;
    Number cosine;  // with the normal, behind the surface
};

// Snell's law, n1 sin1 = n2 sin2. Nothing when all is reflected.
template <typename Number>
std::optional<Refraction<Number>> refract(const Vec<Number> &d, const Vec<Number> &normal,
                                          Number n1, Number n2) {
    const Number ratio = n1 / n2;
    const Number cosine1 = -glm::dot(d, normal);
    const Number sine2_squared = ratio * ratio * (1 - cosine1 * cosine1);
    if (sine2_squared > 1)
        return std::nullopt;
    const Number cosine2 = std::sqrt(1 - sine2_squared);
    return Refraction<Number>{ratio * d + (ratio * cosine1 - cosine2) * normal, cosine2};
}

// The transmitted direction goes beneath the facet, whatever the shading normal made of it.
template <typename Number>
Vec<Number> beneath(const Vec<Number> &transmitted, const Vec<Number> &geometric) {
    const Number height = glm::dot(transmitted, geometric);
    return height > 0 ? transmitted - 2 * height * geometric : transmitted;
}

// The reflected share (Schlick, An Inexpensive BRDF Model for Physically-based Rendering,
// 1994, equation 15), taken on the side where the angle is larger.
template <typename Number> Number schlick(Number n1, Number n2, Number cosine1, Number cosine2) {
    const Number root = (n1 - n2) / (n1 + n2);
    const Number at_normal = root * root;
    const Number rest = 1 - (n1 > n2 ? cosine2 : cosine1);
    return at_normal + (1 - at_normal) * rest * rest * rest * rest * rest;
}

// Fresnel's equations for light that is not polarised: the mean of the shares of what swings across
// the plane of incidence and of what swings within it. Grazing light is all reflected.
template <typename Number> Number fresnel(Number n1, Number n2, Number cosine1, Number cosine2) {
    if (cosine1 <= 0)
        return 1;
    const auto share = [](Number a, Number b) { return (a - b) * (a - b) / ((a + b) * (a + b)); };
    return (share(n1 * cosine1, n2 * cosine2) + share(n1 * cosine2, n2 * cosine1)) / 2;
}

// Beer's law: what is left after `distance`.
template <typename Number>
Vec<Number> transmittance(const Vec<Number> &absorption, Number distance) {
    return {std::exp(-absorption.x * distance), std::exp(-absorption.y * distance),
            std::exp(-absorption.z * distance)};
}

}  // namespace stagelight::reference
