// SPDX-License-Identifier: MIT
// Where a mesh loses its shape as it is stored: far from the origin, tiny, or huge. The truth is
// double, in which the mesh was made.
#include <array>
#include <cmath>

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

}  // namespace
}  // namespace stagelight::stability
