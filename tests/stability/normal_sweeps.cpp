// SPDX-License-Identifier: MIT
// Where a mesh loses its shape as it is stored: far from the origin, tiny, or huge; and how far its
// normals turn. The truth is double, in which the mesh was made.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "device/bvh.h"
#include "kernels/on_device.h"
#include "reference/scenes.h"
#include "scene_types.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

using glm::dvec3, glm::vec4;
using reference::Dice;
using Triangle = std::array<dvec3, 3>;

using StabilityStage09Storage = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, StabilityStage09Storage, each_device(), device_name);

struct Corners {
    vec4 corners[3];
};

// As the host stores it.
template <typename Stored> Stored stored(const Triangle &triangle, auto convert) {
    Stored facet = {};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
            facet.corners[corner][axis] = convert(float(triangle[corner][axis]));
        }
    }
    return facet;
}

// Triangles of meshes, where each stands in the sweep, and how large its mesh is.
struct Cases {
    std::vector<double> x, sizes;
    std::vector<Triangle> triangles;
    Dice dice;

    void add(double at, double size, double offset) {
        for (int i = 0; i < 64; ++i) {
            const dvec3 center = offset * dice.direction();
            const auto corner = [&] { return center + dice.in_cube(size / 2); };
            x.push_back(at);
            sizes.push_back(size);
            triangles.push_back({corner(), corner(), corner()});
        }
    }
};

template <typename Stored>
void measure(Sweep &sweep, const char *method, DeviceProgram program, const Cases &cases,
             auto convert) {
    std::vector<Stored> facets;
    for (const Triangle &triangle : cases.triangles) {
        facets.push_back(stored<Stored>(triangle, convert));
    }
    const auto read = program.run<Corners>("corners", facets);
    for (std::size_t i = 0; i < read.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double off = glm::distance(dvec3(read[i].corners[k]), cases.triangles[i][k]);
            sweep.add(method, cases.x[i], off / cases.sizes[i]);
        }
    }
}

Question question(const char *name, const char *title, const char *x_label, const char *stated) {
    return {.name = name,
            .kind = "storage",
            .title = title,
            .x_label = x_label,
            .y_label = "error of a corner / size of the mesh",
            .limit = 1e-3,  // a pixel of a picture a thousand wide that the mesh fills
            .stated = stated};
}

TEST_P(StabilityStage09Storage, FarTinyAndHuge) {
    Cases far, tiny, huge;
    for (int power = 0; power <= 28; ++power) {
        const double x = std::pow(10, power / 4.0);
        far.add(x, 1, x);
        tiny.add(x, 1 / x, 0);
        huge.add(x, x, 0);
    }
    const DeviceProgram in_float = build("corners.cl");
    const DeviceProgram in_half = build("corners.cl", {}, {{"storage", "half"}});
    const auto measure_both = [&](Sweep &sweep, const Cases &cases) {
        measure<device::Facet>(sweep, "float", in_float, cases, [](float f) { return f; });
        measure<device::HalfFacet>(sweep, "half", in_half, cases, to_half);
    };
    Sweep offset(question("storage_offset", "A mesh far from the origin", "distance / size",
                          "to 10 thousand sizes away"),
                 GetParam());
    measure_both(offset, far);
    offset.expect_holds("half", 1);
    offset.expect_fails("half", 10);
    offset.expect_holds("float", 1e4);
    offset.expect_fails("float", 1e5);
    Sweep small(question("storage_small", "A tiny mesh", "1 / size", "any size"), GetParam());
    measure_both(small, tiny);
    small.expect_holds("half", 1e4);
    small.expect_fails("half", 1e5);  // its smallest step is 2^-24
    small.expect_holds("float", 1e7);
    Sweep large(question("storage_large", "A huge mesh", "size", "any size"), GetParam());
    measure_both(large, huge);
    large.expect_holds("half", 1e5);
    large.expect_fails("half", 1e6);  // it ends at 65504
    large.expect_holds("float", 1e7);
}

// Facets of the unit ball, whose normals are their corners, each with a point of it and a ray to
// there.
struct SmoothFacets {
    std::vector<double> x;
    std::vector<Triangle> facets;
    std::vector<vec4> weights, directions;
    Dice dice;

    void add(double at, const Triangle &facet) {
        const double b = dice.between(0, 1);
        x.push_back(at);
        facets.push_back(facet);
        weights.emplace_back(b, dice.between(0, 1 - b), 0, 0);
        directions.emplace_back(dice.direction(), 0);
    }

    // Not yet of unit length.
    dvec3 blended(std::size_t i) const {
        const double b = weights[i].x, c = weights[i].y;
        return (1 - b - c) * facets[i][0] + b * facets[i][1] + c * facets[i][2];
    }
};

double angle(const dvec3 &a, const dvec3 &b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// How far a normal, and a ray reflected by it, are turned, in radians.
struct Turn {
    double normal, reflected;
};

template <typename Stored, typename StoredNormal>
std::vector<Turn> turns(DeviceProgram program, const SmoothFacets &cases, auto convert) {
    std::vector<Stored> facets;
    std::vector<std::array<StoredNormal, 12>> normals;
    std::vector<device::Triangle> triangles;
    for (const Triangle &facet : cases.facets) {
        const auto first = std::uint32_t(3 * facets.size());
        triangles.push_back({{first, first + 1, first + 2}, 0});
        facets.push_back(stored<Stored>(facet, convert));
        auto &out = normals.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                out[4 * corner + axis] = convert(float(facet[corner][int(axis)]));
            }
        }
    }
    const auto read = program.run<std::array<vec4, 2>>(
        "smooth_normals", cases.weights, cases.directions, triangles, facets, normals);
    std::vector<Turn> all;
    for (std::size_t i = 0; i < read.size(); ++i) {
        const dvec3 normal = glm::normalize(cases.blended(i));
        const dvec3 reflected = glm::reflect(dvec3(cases.directions[i]), normal);
        all.push_back({angle(dvec3(read[i][0]), normal), angle(dvec3(read[i][1]), reflected)});
    }
    return all;
}

// What a dozen roundings of float turn a direction by, at the most.
const double float_turn = std::ldexp(16, -24);

// A half has 11 bits: a part of a unit vector is rounded by up to 2^-12, and the vector by the root
// of 3 times that. The sum of the corners' normals by their weights is no wronger, but may be
// shorter.
double half_turn(const dvec3 &blended) {
    return std::asin(std::sqrt(3.0) * std::ldexp(1, -12) / glm::length(blended)) + float_turn;
}

class StabilityStage09Normals : public OnDevice {
protected:
    static std::vector<Turn> in_float(const SmoothFacets &cases) {
        return turns<device::Facet, float>(build("smooth_normals.cl", needs), cases,
                                           [](float f) { return f; });
    }

    // Held to what half can do, which it comes near to.
    static std::vector<Turn> in_half(const SmoothFacets &cases) {
        const auto all = turns<device::HalfFacet, std::uint16_t>(
            build("smooth_normals.cl", needs, {{"storage", "half"}}), cases, to_half);
        double nearest = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double bound = half_turn(cases.blended(i));
            EXPECT_LE(all[i].normal, bound) << cases.x[i];
            EXPECT_LE(all[i].reflected, 2 * bound) << cases.x[i];
            nearest = std::max(nearest, all[i].normal / bound);
        }
        EXPECT_GT(nearest, 0.75);
        return all;
    }

private:
    static inline const SceneNeeds needs{
        {"HAS_TRIANGLES", 1}, {"HAS_TREE", 1}, {"BVH_WIDTH", 4}, {"STACK_SIZE", 1}, {"MAX_DEPTH", 1}};
};
INSTANTIATE_TEST_SUITE_P(On, StabilityStage09Normals, each_device(), device_name);

TEST_P(StabilityStage09Normals, OfEveryDirection) {
    SmoothFacets cases;
    for (int power = 0; power <= 16; ++power) {
        const double x = std::pow(10, power / 2.0);
        for (int i = 0; i < 256; ++i) {
            const double turn = cases.dice.between(0, 2 * std::numbers::pi);
            dvec3 normal(0);
            normal[i % 3] = 1 / x;
            normal[(i + 1) % 3] = std::cos(turn);
            normal[(i + 2) % 3] = std::sin(turn);
            normal = glm::normalize(normal);
            cases.add(x, {normal, normal, normal});
        }
    }
    Sweep sweep({.name = "storage_normals",
                 .kind = "storage",
                 .title = "Normals, and what they reflect",
                 .x_label = "1 / one part of the normal",
                 .y_label = "degrees that it is turned by",
                 .limit = glm::degrees(float_turn),
                 .stated = "for every direction"},
                GetParam());
    const auto add = [&](const std::string &method, const std::vector<Turn> &all) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            sweep.add(method, cases.x[i], glm::degrees(all[i].normal));
            sweep.add(method + ", reflected", cases.x[i], glm::degrees(all[i].reflected));
        }
    };
    add("float", in_float(cases));
    add("half", in_half(cases));
    for (const char *what : {"", ", reflected"}) {
        sweep.expect_holds(std::string("float") + what, 1e8);
        sweep.expect_fails(std::string("half") + what, 1);
    }
}

// Where facets are small, their corners' normals are nearly one and the same: a mirror shows the
// steps.
TEST_P(StabilityStage09Normals, OfFineMeshes) {
    SmoothFacets cases;
    for (int power = 2; power <= 16; ++power) {
        const double x = std::pow(10, power / 2.0);
        for (int i = 0; i < 256; ++i) {
            const dvec3 normal = cases.dice.direction();
            const dvec3 across = glm::normalize(glm::cross(normal, cases.dice.direction()));
            const double step = 2 * std::numbers::pi / x;
            const auto beside = [&](const dvec3 &way) {
                return std::cos(step) * normal + std::sin(step) * way;
            };
            cases.add(x, {normal, beside(across), beside(glm::cross(normal, across))});
        }
    }
    Sweep sweep({.name = "storage_fine",
                 .kind = "storage",
                 .title = "Mirrors of ever smaller facets",
                 .x_label = "facets around the mesh",
                 .y_label = "turn of a reflected ray / turn from corner to corner",
                 .limit = 0.1,
                 .stated = "to a million facets around"},
                GetParam());
    const auto add = [&](const char *method, const std::vector<Turn> &all) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            sweep.add(method, cases.x[i], all[i].reflected / (2 * std::numbers::pi / cases.x[i]));
        }
    };
    add("float", in_float(cases));
    add("half", in_half(cases));
    sweep.expect_holds("half", 100);
    sweep.expect_fails("half", 1e4);
    sweep.expect_holds("float", 1e6);
    sweep.expect_fails("float", 1e8);
}

}  // namespace
}  // namespace stagelight::stability
