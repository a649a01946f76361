// SPDX-License-Identifier: MIT
// Each way off a surface, by its formula, wherever along the axes the surface lies.
#include <bit>
#include <cmath>

#include "kernels/on_device.h"
#include "kernels/worst.h"
#include "reference/scenes.h"

namespace stagelight {
namespace {

using glm::vec3, glm::vec4;

using KernelsStage02Origin = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage02Origin, each_device(), device_name);
using KernelsStage10Origin = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage10Origin, each_device(), device_name);

struct Leaving {
    vec4 ray;       // its origin; in w the distance
    vec4 position;  // in w the shape's bound
    vec3 normal;
};

// Largest along each axis in turn, on both sides of 0, from far away to within the 1/32 where
// counting units in the last place ends.
std::vector<Leaving> surfaces() {
    std::vector<Leaving> all;
    reference::Dice dice;
    for (int i = 0; i < 600; ++i) {
        const int axis = i % 3;
        const double sign = i % 2 == 0 ? 1 : -1;
        const double size = std::pow(10, dice.between(-3, 4));
        glm::dvec3 origin = dice.in_cube(0.4 * size), position = dice.in_cube(0.4 * size);
        origin[axis] = sign * size;
        position[axis] = -sign * size;
        all.push_back({vec4(origin, dice.between(0, 1)), vec4(position, 1e-6 * size),
                       vec3(dice.direction())});
    }
    return all;
}

// Wächter and Binder: so many units in the last place, away from 0 where the normal points away.
float by_counting(float position, float normal) {
    if (std::abs(position) < 1 / 32.0F) {
        return position + normal / 65536;
    }
    const int steps = static_cast<int>(256 * normal);
    return std::bit_cast<float>(std::bit_cast<int>(position) + (position < 0 ? -steps : steps));
}

// The way that the formula says; in w the offset along the normal.
vec4 expected(const std::string &method, const Leaving &at) {
    const vec3 position(at.position);
    const vec3 distances = glm::abs(vec3(at.ray));
    const float offset =
        method == "fixed" ? 1e-3F
        : method == "scaled"
            ? 2e-6F * (std::max({distances.x, distances.y, distances.z}) + at.ray.w)
            : at.position.w;
    if (method != "integer") {
        return {position + offset * at.normal, offset};
    }
    return {by_counting(position.x, at.normal.x), by_counting(position.y, at.normal.y),
            by_counting(position.z, at.normal.z), offset};
}

void expect_formulas(const std::function<DeviceProgram(const Methods &)> &build) {
    const std::vector<Leaving> all = surfaces();
    std::vector<vec4> rays, positions, normals;
    for (const Leaving &at : all) {
        rays.push_back(at.ray);
        positions.push_back(at.position);
        normals.emplace_back(at.normal, 0);
    }
    for (const char *method : {"error_bound", "scaled", "fixed", "integer"}) {
        const auto results =
            build({{"origin", method}}).run<vec4>("offsets", rays, positions, normals);
        Worst origin(std::string("origin by ") + method), offset("offset");
        for (std::size_t i = 0; i < all.size(); ++i) {
            const vec4 right = expected(method, all[i]);
            // The last sum is rounded in units of the coordinates.
            const double size = glm::length(glm::dvec3(all[i].position));
            origin.compare(i, glm::dvec3(results[i]), glm::dvec3(right), ulp * size);
            offset.compare(i, results[i].w, right.w, 4 * ulp * right.w);
        }
        origin.expect(600);
        offset.expect(600);
    }
}

TEST_P(KernelsStage02Origin, IsWhereTheFormulaSays) {
    expect_formulas([](const Methods &methods) { return build("origin.cl", {}, methods); });
}

TEST_P(KernelsStage10Origin, IsWhereTheFormulaSays) {
    expect_formulas([](const Methods &methods) {
        return build("packet_origin.cl", {{"WIDTH", 4}}, methods);
    });
}

}  // namespace
}  // namespace stagelight
