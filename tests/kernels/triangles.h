// SPDX-License-Identifier: MIT
// Triangles with rays or lines through and past them.
#pragma once

#include <cmath>

#include "kernels/on_device.h"
#include "kernels/worst.h"
#include "reference/scenes.h"

namespace stagelight {

using glm::dvec3, glm::vec3, glm::vec4;
using Wide = reference::Vec<long double>;  // the truth: float inputs are exact in it

// TRIANGLE_COUNT lets scene.cl know of meshes.
inline const SceneNeeds with_triangles{{"HAS_TRIANGLES", 1}};

// Rays, or lines: `ends` are directions or destinations.
struct TriangleCases {
    std::vector<vec4> origins, ends, a, b, c;

    void add(const dvec3 &origin, const dvec3 &end, const std::array<dvec3, 3> &corners) {
        origins.emplace_back(vec3(origin), 0);
        ends.emplace_back(vec3(end), 0);
        a.emplace_back(vec3(corners[0]), 0);
        b.emplace_back(vec3(corners[1]), 0);
        c.emplace_back(vec3(corners[2]), 0);
    }
};

// Edges of a millionth to a million, every fourth triangle a sliver of down to a
// thousandth of its length, aimed at within and around, from both sides.
struct RandomTriangle {
    std::array<dvec3, 3> corners;
    dvec3 aim, toward;  // a point of its plane near it; a direction towards it
    double size;

    RandomTriangle(reference::Dice &dice, int i) : size(std::pow(10, dice.between(-6, 6))) {
        const dvec3 middle = size * dice.in_cube(10);
        for (dvec3 &corner : corners) {
            corner = middle + size * dice.in_cube(1);
        }
        if (i % 4 == 0) {
            const double width = std::pow(10, dice.between(-3, 0));
            corners[2] = glm::mix(corners[0], corners[1], dice.between(-0.5, 1.5))
                         + width * (corners[2] - middle);
        }
        const double u = dice.between(-0.2, 1.2), v = dice.between(-0.2, 1.2 - u);
        aim = (1 - u - v) * corners[0] + u * corners[1] + v * corners[2];
        toward = dice.direction();
    }
};

// What Möller and Trumbore's method works out, in long double, and how far it may be off in
// float: each product of three differences by a few roundings of the product of their sizes.
struct TriangleTruth {
    double t, u, v;
    double t_rounding, u_rounding, v_rounding;
    bool inside, certain;

    TriangleTruth(const TriangleCases &cases, std::size_t i, const Wide &along) {
        const Wide edge_b = Wide(cases.b[i]) - Wide(cases.a[i]);
        const Wide edge_c = Wide(cases.c[i]) - Wide(cases.a[i]);
        const Wide to_origin = Wide(cases.origins[i]) - Wide(cases.a[i]);
        const long double volume = glm::dot(along, glm::cross(edge_c, edge_b));
        t = double(glm::dot(to_origin, glm::cross(edge_b, edge_c)) / volume);
        u = double(glm::dot(along, glm::cross(edge_c, to_origin)) / volume);
        v = double(glm::dot(along, glm::cross(to_origin, edge_b)) / volume);

        const auto size = [](const Wide &edge) { return double(glm::length(edge)); };
        const double b = size(edge_b), c = size(edge_c), o = size(to_origin), d = size(along);
        const double rounding = 2 * ulp / std::abs(double(volume));
        u_rounding = rounding * d * c * (o + std::abs(u) * b);
        v_rounding = rounding * d * b * (o + std::abs(v) * c);
        t_rounding = rounding * b * c * (o + std::abs(t) * d);
        const double outside = std::max({-u, -v, u + v - 1});
        certain = rounding * b * c * d < 0.5
                  && std::abs(outside) > std::max({u_rounding, v_rounding, u_rounding + v_rounding})
                  && std::abs(t) > t_rounding;
        inside = outside < 0 && t > 0;
    }
};

// The triangle (0, 0, 0), (4, 0, 0), (0, 4, 0), seen straight down the z axis: all numbers are
// exact, so that edges and corners, which belong to it, can be hit on the spot.
inline const std::array<dvec3, 3> flat{dvec3(0, 0, 0), dvec3(4, 0, 0), dvec3(0, 4, 0)};

}  // namespace stagelight
