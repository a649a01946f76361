// SPDX-License-Identifier: MIT
#include "kernels/triangles.h"

namespace stagelight {
namespace {

using reference::Dice;
constexpr float infinity = std::numeric_limits<float>::infinity();

using KernelsStage05Triangle = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage05Triangle, each_device(), device_name);

TEST_P(KernelsStage05Triangle, RaysMatchLongDouble) {
    Dice dice;
    TriangleCases cases;
    for (int i = 0; i < 8192; ++i) {
        const RandomTriangle it(dice, i);
        const double away = it.size * std::pow(10, dice.between(-1, 3)) * (i % 16 == 0 ? -1 : 1);
        cases.add(it.aim - away * it.toward, it.toward, it.corners);
    }
    const auto hits =
        build("triangle.cl", with_triangles)
            .run<vec4>("ray_triangle", cases.origins, cases.ends, cases.a, cases.b, cases.c);
    Worst meets("hit or miss"), distance("distance"), u("u"), v("v");
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const TriangleTruth truth(cases, i, Wide(cases.ends[i]));
        if (!truth.certain) {
            continue;
        }
        meets.compare(i, hits[i].x < infinity, truth.inside, 0);
        if (truth.inside && hits[i].x < infinity) {
            distance.compare(i, hits[i].x, truth.t, truth.t_rounding);
            u.compare(i, hits[i].y, truth.u, truth.u_rounding);
            v.compare(i, hits[i].z, truth.v, truth.v_rounding);
        }
    }
    meets.expect(7000);
    distance.expect(2000);
    u.expect(2000);
    v.expect(2000);
}

TEST_P(KernelsStage05Triangle, NastyRaysHitWhereTheClosedFormSays) {
    struct Case {
        dvec3 origin, direction;
        vec3 expected;  // distance, u, v
        const char *what;
    };
    const vec3 none(infinity, 0, 0);
    const double nan = NAN, inf = INFINITY;
    const std::vector<Case> list{
        {{1, 1, 3}, {0, 0, -1}, {3, 0.25, 0.25}, "from in front"},
        {{2, 1, -3}, {0, 0, 1}, {3, 0.5, 0.25}, "from behind"},
        {{0, 0, 3}, {0, 0, -1}, {3, 0, 0}, "corner a"},
        {{4, 0, 3}, {0, 0, -1}, {3, 1, 0}, "corner b"},
        {{0, 4, 3}, {0, 0, -1}, {3, 0, 1}, "corner c"},
        {{3, 0, 3}, {0, 0, -1}, {3, 0.75, 0}, "edge a b"},
        {{0, 3, -3}, {0, 0, 1}, {3, 0, 0.75}, "edge a c, from behind"},
        {{3, 1, 3}, {0, 0, -1}, {3, 0.75, 0.25}, "edge b c"},
        {{-1e-6, 1, 3}, {0, 0, -1}, none, "just beside the edge a c"},
        {{1, -1e-6, 3}, {0, 0, -1}, none, "just beside the edge a b"},
        {{2.000002, 2, 3}, {0, 0, -1}, none, "just beside the edge b c"},
        {{1, 1, 3}, {0, 0, 1}, none, "behind the origin"},
        {{1, 1, 0}, {0, 0, -1}, none, "from the triangle"},
        {{1, 1, 3}, {1, 0, 0}, none, "parallel"},
        {{-1, 1, 0}, {1, 0, 0}, none, "in its plane"},
        {{1, 1, 3}, {0, 0, 0}, none, "no direction"},
        {{nan, 1, 3}, {0, 0, -1}, none, "no place"},
        {{1, 1, nan}, {0, 0, -1}, none, "no height"},
        {{1, 1, 3}, {nan, 0, -1}, none, "a direction that is none"},
        {{1, 1, inf}, {0, 0, -1}, none, "from infinitely far"},
    };
    DeviceProgram program = build("triangle.cl", with_triangles);
    for (const double scale : {1.0, std::ldexp(1.0, -20), std::ldexp(1.0, 20)}) {
        TriangleCases cases;
        for (const Case &it : list) {
            cases.add(scale * it.origin, it.direction,
                      {scale * flat[0], scale * flat[1], scale * flat[2]});
        }
        const auto hits =
            program.run<vec4>("ray_triangle", cases.origins, cases.ends, cases.a, cases.b, cases.c);
        for (std::size_t i = 0; i < list.size(); ++i) {
            const auto &[origin, direction, expected, what] = list[i];
            EXPECT_EQ(hits[i].x, expected.x * float(scale)) << what << ", scale " << scale;
            if (expected.x < infinity) {
                EXPECT_EQ(hits[i].y, expected.y) << what << ", u, scale " << scale;
                EXPECT_EQ(hits[i].z, expected.z) << what << ", v, scale " << scale;
            }
        }
    }
}

// Triangles that have no area, or corners that are no place.
TEST_P(KernelsStage05Triangle, WhatIsNoTriangleIsMissed) {
    const double nan = NAN, inf = INFINITY;
    const std::vector<std::array<dvec3, 3>> list{
        {dvec3(1, 1, 0), dvec3(1, 1, 0), dvec3(1, 1, 0)},
        {dvec3(0, 0, 0), dvec3(2, 2, 0), dvec3(4, 4, 0)},
        {dvec3(0, 0, 0), dvec3(0, 0, 0), dvec3(4, 4, 0)},
        {dvec3(nan, 0, 0), dvec3(4, 0, 0), dvec3(0, 4, 0)},
        {dvec3(0, 0, 0), dvec3(4, nan, 0), dvec3(0, 4, 0)},
        {dvec3(0, 0, 0), dvec3(4, 0, 0), dvec3(0, 4, nan)},
        {dvec3(nan), dvec3(nan), dvec3(nan)},
        {dvec3(0, 0, 0), dvec3(inf, 0, 0), dvec3(0, 4, 0)},
        {dvec3(-inf, 0, 0), dvec3(4, 0, 0), dvec3(0, inf, 0)},
    };
    TriangleCases rays, lines;
    for (const auto &corners : list) {
        rays.add({1, 1, 3}, {0, 0, -1}, corners);
        lines.add({1, 1, 3}, {1, 1, -3}, corners);
    }
    DeviceProgram program = build("triangle.cl", with_triangles);
    const auto hits =
        program.run<vec4>("ray_triangle", rays.origins, rays.ends, rays.a, rays.b, rays.c);
    const auto meets =
        program.run<int>("line_triangle", lines.origins, lines.ends, lines.a, lines.b, lines.c);
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(hits[i].x, infinity) << "ray, case " << i;
        EXPECT_EQ(meets[i], 0) << "line, case " << i;
    }
}

}  // namespace
}  // namespace stagelight
