// SPDX-License-Identifier: MIT
// The tree of boxes: that it holds every triangle once, in boxes that hold it, and that what is
// drawn with it is what is drawn by trying all triangles.
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include <fmt/format.h>

#include "device/bvh.h"
#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

// Triangles of edge `size` around points of a cube from -1 to 1.
Scene soup(int count, double size) {
    Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
    std::mt19937 random(17);
    std::uniform_real_distribution<double> within(-1, 1);
    const auto point = [&] { return dvec3(within(random), within(random), within(random)); };
    for (int i = 0; i < count; ++i) {
        const dvec3 corner = point();
        add_flat_triangle(scene, corner, corner + size * point(), corner + size * point(), 0);
    }
    return scene;
}

class Stage09Bvh : public testing::TestWithParam<int> {
protected:
    // Follows all ways down, and counts how often each triangle is met.
    struct Walk {
        const Scene &scene;
        const Bvh &bvh;
        std::vector<int> met = std::vector<int>(bvh.order.size());
        std::size_t nodes = 0;
        int waiting = 0;  // the most that can be

        std::uint32_t word(std::size_t node, std::size_t row, std::size_t child) const {
            return bvh.nodes.at((node * 8 + row) * std::size_t(bvh.layout.width) + child);
        }
        float plane(std::size_t node, int axis, bool high, std::size_t child) const {
            return std::bit_cast<float>(word(node, std::size_t(axis + 3 * high), child));
        }
        bool is_there(std::size_t node, std::size_t child) const {
            return plane(node, 0, false, child) <= plane(node, 0, true, child);
        }

        void into(std::size_t node, int left) {
            ++nodes;
            waiting = std::max(waiting, left);
            std::vector<std::size_t> inner;
            for (std::size_t child = 0; child < std::size_t(bvh.layout.width); ++child) {
                if (!is_there(node, child)) {
                    continue;
                }
                if (word(node, 7, child) > 0) {
                    leaf(node, child);
                } else {
                    inner.push_back(child);
                }
            }
            for (const std::size_t child : inner) {
                const std::uint32_t below = word(node, 6, child);
                ASSERT_GT(below, node) << "a node comes before its children";
                expect_within(below, node, child);
                into(below, left - 1 + static_cast<int>(inner.size()));
            }
        }
        void leaf(std::size_t node, std::size_t child) {
            const std::uint32_t first = word(node, 6, child);
            ASSERT_LE(word(node, 7, child), 8);
            for (std::uint32_t i = first; i < first + word(node, 7, child); ++i) {
                ++met.at(bvh.order.at(i));
                for (const std::uint32_t vertex : scene.triangles[bvh.order[i]].vertices) {
                    const glm::vec3 at(scene.vertices[vertex].position);
                    for (int axis = 0; axis < 3; ++axis) {
                        EXPECT_TRUE(plane(node, axis, false, child) < at[axis]
                                    && at[axis] < plane(node, axis, true, child))
                            << "no room for rounding";
                    }
                }
            }
        }
        // The boxes of a node are in that of the child that it is.
        void expect_within(std::size_t below, std::size_t node, std::size_t of) const {
            for (std::size_t child = 0; child < std::size_t(bvh.layout.width); ++child) {
                for (int axis = 0; axis < 3 && is_there(below, child); ++axis) {
                    EXPECT_LE(plane(node, axis, false, of), plane(below, axis, false, child));
                    EXPECT_LE(plane(below, axis, true, child), plane(node, axis, true, of));
                }
            }
        }
    };

    static Bvh expect_whole(const Scene &scene) {
        Bvh bvh = build_bvh(scene, {.width = GetParam()});
        Walk walk{scene, bvh};
        walk.into(0, 1);
        EXPECT_EQ(walk.met, std::vector<int>(scene.triangles.size(), 1));
        EXPECT_EQ(walk.waiting, bvh.stack_size);
        EXPECT_EQ(walk.nodes * 8 * std::size_t(bvh.layout.width), bvh.nodes.size());
        return bvh;
    }
};
INSTANTIATE_TEST_SUITE_P(Nodes, Stage09Bvh, testing::Values(2, 4, 8));

TEST_P(Stage09Bvh, OfNoTrianglesHasNoNodes) {
    EXPECT_TRUE(build_bvh(soup(0, 1), {.width = GetParam()}).nodes.empty());
}

TEST_P(Stage09Bvh, HoldsEveryTriangleOnce) {
    for (const int count : {1, 2, 3, 8, 9, 100, 20000}) {
        SCOPED_TRACE(count);
        expect_whole(soup(count, 0.05));
    }
}

TEST_P(Stage09Bvh, OfManyIsNoDeeperThanItNeedsToBe) {
    EXPECT_LT(expect_whole(soup(20000, 0.02)).stack_size, 15 * GetParam());
}

TEST_P(Stage09Bvh, DividesTrianglesInOnePlaceByTheirNumber) {
    Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
    for (int i = 0; i < 10000; ++i) {
        add_flat_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0);
    }
    const int levels = 12 / (std::bit_width(unsigned(GetParam())) - 1) + 3;  // 10000 / 8 leaves
    EXPECT_LE(expect_whole(scene).stack_size, levels * (GetParam() - 1) + 1);
}

// Each triangle is three times as far out and as large as the one before: costs alone peel them off
// by ones and twos, 45 deep.
TEST_P(Stage09Bvh, StaysBoundedWhereCostsLeadDeep) {
    Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
    for (int i = 0; i < 80; ++i) {
        const double size = std::pow(3.0, i - 40);
        add_flat_triangle(scene, {size, 0, 0}, {1.5 * size, 0, 0}, {size, 0.5 * size, 0}, 0);
    }
    EXPECT_LE(expect_whole(scene).stack_size, 37);
}

TEST_P(Stage09Bvh, TakesCoordinatesNearTheLargest) {
    Scene scene = soup(1000, 0.1);
    for (Vertex &vertex : scene.vertices) {
        vertex.position *= 3e38;
    }
    expect_whole(scene);
}

TEST_P(Stage09Bvh, IsTheSameEachTime) {
    const Scene scene = soup(20000, 0.05);
    const Bvh first = build_bvh(scene, {.width = GetParam()});
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(build_bvh(scene, {.width = GetParam()}).nodes, first.nodes);
    }
}

// How the tree is walked: rays side by side, and children of a node.
struct Walking {
    const char *device;
    const char *width;
    const char *nodes;
};

void PrintTo(const Walking &walking, std::ostream *stream) {
    *stream << walking.device << " width " << walking.width << " nodes " << walking.nodes;
}

// Drawn with the tree and, by stage 05, without: no pixel sees another triangle.
class Stage09Picture : public testing::TestWithParam<Walking> {
protected:
    static Frame draw(const char *stage, const Scene &scene,
                      const char *triangle = "moeller_trumbore") {  // stage 05's
        RenderSettings settings = settings_of(scene);
        settings.methods = {
            {"width", GetParam().width}, {"nodes", GetParam().nodes}, {"triangle", triangle}};
        return Renderer(choose_device(GetParam().device), stage, scene, settings).render();
    }
    // Shadow rays and lines, and rays from wherever a mirror is.
    static void expect_same(Scene scene, const Material &material) {
        scene.width = scene.height = 65;  // so that one ray goes straight ahead
        scene.max_depth = 4;
        add_material(scene, material);  // the first: that of all triangles
        add_directional_light(scene, {0, -1, 0}, {1, 1, 1}, 0.5);
        add_point_light(scene, {0, 3, 4}, {1, 1, 1}, 10);
        const Frame with = draw("09_acceleration", scene);
        const Frame without = draw("05_meshes", scene);
        int different = 0;
        for (std::size_t i = 0; i < with.image.pixels.size(); ++i) {
            different += glm::distance(with.image.pixels[i], without.image.pixels[i]) > 1e-4F;
        }
        EXPECT_EQ(different, 0) << "of " << with.image.pixels.size() << " pixels";
        EXPECT_EQ(with.rays.shadow, without.rays.shadow);
        EXPECT_EQ(with.rays.reflection, without.rays.reflection);
        EXPECT_GT(with.rays.shadow + with.rays.reflection, 100) << "what was seen?";
    }

    // A wall of 2 n^2 triangles at z, from -1 to 1, whose edges are along the axes and whose
    // corners go round one way or the other.
    static void add_wall(Scene &scene, int n, double z, bool clockwise = false) {
        const double step = 2.0 / n;
        for (int i = 0; i < n * n; ++i) {
            const dvec3 corner(-1 + step * (i % n), -1 + step * (i / n), z);
            dvec3 right = corner + dvec3(step, 0, 0);
            dvec3 up = corner + dvec3(0, step, 0);
            const dvec3 across = up + dvec3(step, 0, 0);
            if (clockwise) {
                std::swap(right, up);
            }
            add_flat_triangle(scene, corner, right, up, 0);
            add_flat_triangle(scene, right, across, up, 0);
        }
    }
};
// On rusticl as it prefers: its compiler takes minutes for the wide kernels. (All widths are held
// to the goldens.)
INSTANTIATE_TEST_SUITE_P(Walks, Stage09Picture, testing::ValuesIn([] {
                             std::vector<Walking> walks;
                             for (const char *device : implementations) {
                                 walks.push_back({device, "1", "4"});
                                 if (!is_rusticl(device)) {
                                     walks.push_back({device, "4", "2"});
                                     walks.push_back({device, "16", "8"});
                                 }
                             }
                             return walks;
                         }()),
                         [](const auto &walking) {
                             return fmt::format("{}_{}_{}", name_in_tests(walking.param.device),
                                                walking.param.width, walking.param.nodes);
                         });

TEST_P(Stage09Picture, OfManyTrianglesIsThatWithoutATree) {
    expect_same(soup(1500, 0.15), diffuse({1, 1, 1}));
    expect_same(soup(1500, 0.15), mirror({0.9, 0.9, 0.9}));
}

TEST_P(Stage09Picture, OfOneAndOfTwoTrianglesToo) {
    expect_same(soup(1, 3), diffuse({1, 1, 1}));
    expect_same(soup(2, 3), diffuse({1, 1, 1}));
}

// Boxes without thickness, rays along the axes, light straight from above along the walls, and an
// eye in the very plane of the triangles' edges.
TEST_P(Stage09Picture, OfWallsSeenAlongTheAxesToo) {
    for (const int n : {4, 5}) {
        Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
        add_wall(scene, n, 0);
        add_wall(scene, n, -1);
        expect_same(scene, diffuse({1, 1, 1}));
        expect_same(scene, mirror({1, 1, 1}));
    }
}

// Six triangles meet where the ray goes through: their edges belong to them, whichever way their
// corners go round.
TEST_P(Stage09Picture, HasNoHoleWhereCornersMeet) {
    for (const bool clockwise : {false, true}) {
        Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
        scene.background = {1, 0, 0};
        add_wall(scene, 4, 0, clockwise);
        add_material(scene, diffuse({1, 1, 1}));
        EXPECT_EQ(draw("09_acceleration", scene, "woop").image.pixels.at(0), glm::vec3(0))
            << clockwise;
    }
}

TEST_P(Stage09Picture, FromWithinTheSlabsToo) {
    Scene scene = one_pixel({0, 0, 0.5}, {0, 0, -1});
    add_wall(scene, 4, -0.5);
    add_wall(scene, 4, 0.5);
    expect_same(scene, diffuse({1, 1, 1}));
}

// A shadow line ends at its light: neither what is just before it nor what is behind may be taken
// for the other. One of the lights is behind a plane, and reaches nothing that is seen.
TEST_P(Stage09Picture, WithALightAmongTheTrianglesToo) {
    Scene scene = soup(1500, 0.15);
    add_plane(scene, {-1, 0, 0}, {0.3, 0, 0}, diffuse({1, 1, 1}));
    add_point_light(scene, {2, 1, 1}, {1, 1, 1}, 5);
    add_point_light(scene, {0.1, 0.05, 0}, {1, 1, 1}, 1);
    add_point_light(scene, {-0.4, 0.3, 0.5}, {1, 1, 1}, 1);
    expect_same(scene, diffuse({1, 1, 1}));
}

TEST_P(Stage09Picture, OfAnyScaleToo) {
    for (const double scale : {1e-4, 1e4}) {
        Scene scene = soup(300, 0.2);
        for (Vertex &vertex : scene.vertices) {
            vertex.position *= scale;
        }
        scene.camera.position *= scale;
        expect_same(scene, mirror({1, 1, 1}));
    }
}

}  // namespace
}  // namespace stagelight::render
