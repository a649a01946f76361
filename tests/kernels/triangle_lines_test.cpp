// SPDX-License-Identifier: MIT
#include "kernels/triangles.h"

namespace stagelight {
namespace {

using reference::Dice;

using KernelsStage05TriangleLines = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage05TriangleLines, each_device(), device_name);

TEST_P(KernelsStage05TriangleLines, LinesMatchLongDouble) {
    Dice dice;
    TriangleCases cases;
    for (int i = 0; i < 8192; ++i) {
        const RandomTriangle it(dice, i);
        const double before = it.size * std::pow(10, dice.between(-2, 2));
        const double beyond = it.size * dice.between(-1, 1);
        cases.add(it.aim - before * it.toward, it.aim + beyond * it.toward, it.corners);
    }
    const auto meets =
        build("triangle.cl", with_triangles)
            .run<int>("line_triangle", cases.origins, cases.ends, cases.a, cases.b, cases.c);
    Worst worst("line meets triangle");
    for (std::size_t i = 0; i < meets.size(); ++i) {
        const TriangleTruth truth(cases, i, Wide(cases.ends[i]) - Wide(cases.origins[i]));
        if (truth.certain && std::abs(truth.t - 1) > truth.t_rounding) {
            worst.compare(i, meets[i], truth.inside && truth.t < 1, 0);
        }
    }
    worst.expect(7000);
}

TEST_P(KernelsStage05TriangleLines, NastyLinesMeetItOnlyBetweenTheirEnds) {
    struct Case {
        dvec3 origin, destination;
        int expected;
        const char *what;
    };
    const std::vector<Case> list{
        {{1, 1, 3}, {1, 1, -1}, 1, "through"},
        {{1, 1, -1}, {1, 1, 3}, 1, "through, from behind"},
        {{1, 1, 3}, {1, 1, 1}, 0, "ends before"},
        {{1, 1, -1}, {1, 1, -3}, 0, "starts beyond"},
        {{1, 1, 3}, {1, 1, 0}, 0, "to a light on it"},
        {{1, 1, -3}, {1, 1, 0}, 0, "to a light on it, from behind"},
        {{1, 1, 0}, {1, 1, 3}, 0, "from it"},
        {{3, 3, 3}, {3, 3, -3}, 0, "passes by"},
        {{-1, 1, 0}, {9, 1, 0}, 0, "in its plane"},
        {{1, 1, 3}, {1, 1, 3}, 0, "no length"},
        {{3, 0, 3}, {3, 0, -3}, 1, "through an edge"},
        {{0, 4, 3}, {0, 4, -3}, 1, "through a corner"},
        {{1, NAN, 3}, {1, 1, -3}, 0, "no place"},
    };
    TriangleCases cases;
    for (const Case &it : list) {
        cases.add(it.origin, it.destination, flat);
    }
    const auto meets =
        build("triangle.cl", with_triangles)
            .run<int>("line_triangle", cases.origins, cases.ends, cases.a, cases.b, cases.c);
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(meets[i], list[i].expected) << list[i].what;
    }
}

}  // namespace
}  // namespace stagelight
