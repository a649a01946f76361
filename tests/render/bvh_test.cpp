// SPDX-License-Identifier: MIT
// The tree of boxes: that it holds every shape once, in boxes that hold it, and that what is drawn
// with it is what is drawn by trying all shapes.
#include <cmath>
#include <cstdlib>
#include <cstring>
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

class Stage09Bvh : public testing::Test {
protected:
    // Follows all ways down, and counts how often each shape is met.
    struct Walk {
        const Scene &scene;
        const Bvh &bvh;
        std::vector<int> triangles = std::vector<int>(scene.triangles.size());
        std::vector<int> spheres = std::vector<int>(scene.spheres.size());
        std::size_t nodes = 0;
        int waiting = 0;  // the most that can be

        float plane(std::size_t node, int axis, bool high, std::size_t child) const {
            return bvh.nodes.at(node).planes[axis + 3 * high].s[child];
        }
        bool is_there(std::size_t node, std::size_t child) const {
            return plane(node, 0, false, child) <= plane(node, 0, true, child);
        }

        void into(std::size_t node, int left) {
            ++nodes;
            waiting = std::max(waiting, left);
            std::vector<std::size_t> inner;
            for (std::size_t child = 0; child < 4; ++child) {
                if (!is_there(node, child)) {
                    continue;
                }
                if (bvh.nodes.at(node).count[child] != 0) {
                    leaf(node, child);
                } else {
                    inner.push_back(child);
                }
            }
            for (const std::size_t child : inner) {
                const auto below = static_cast<std::size_t>(bvh.nodes.at(node).first[child]);
                ASSERT_GT(below, node) << "a node comes before its children";
                expect_within(below, node, child);
                into(below, left - 1 + static_cast<int>(inner.size()));
            }
        }
        void leaf(std::size_t node, std::size_t child) {
            const auto first = static_cast<std::size_t>(bvh.nodes.at(node).first[child]);
            const int count = bvh.nodes.at(node).count[child];
            ASSERT_LE(std::abs(count), 8);
            for (std::size_t i = first; i < first + std::size_t(std::abs(count)); ++i) {
                if (count < 0) {
                    const std::uint32_t sphere = bvh.spheres.at(i);
                    ++spheres.at(sphere);
                    const Sphere &at = scene.spheres[sphere];
                    expect_holds(node, child, glm::vec3(at.center - at.radius));
                    expect_holds(node, child, glm::vec3(at.center + at.radius));
                    continue;
                }
                const std::uint32_t triangle = bvh.triangles.at(i);
                ++triangles.at(triangle);
                for (const std::uint32_t vertex : scene.triangles[triangle].vertices) {
                    expect_holds(node, child, glm::vec3(scene.vertices[vertex].position));
                }
            }
        }
        void expect_holds(std::size_t node, std::size_t child, const glm::vec3 &point) const {
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_TRUE(plane(node, axis, false, child) < point[axis]
                            && point[axis] < plane(node, axis, true, child))
                    << "not padded against rounding";
            }
        }
        // The boxes of a node are in that of the child that it is.
        void expect_within(std::size_t below, std::size_t node, std::size_t of) const {
            for (std::size_t child = 0; child < 4; ++child) {
                for (int axis = 0; axis < 3 && is_there(below, child); ++axis) {
                    EXPECT_LE(plane(node, axis, false, of), plane(below, axis, false, child));
                    EXPECT_LE(plane(below, axis, true, child), plane(node, axis, true, of));
                }
            }
        }
    };

    static Bvh expect_whole(const Scene &scene) {
        Bvh bvh = build_bvh(scene);
        Walk walk{scene, bvh};
        walk.into(0, 1);
        EXPECT_EQ(walk.triangles, std::vector<int>(scene.triangles.size(), 1));
        EXPECT_EQ(walk.spheres, std::vector<int>(scene.spheres.size(), 1));
        EXPECT_EQ(walk.waiting, bvh.stack_size);
        EXPECT_EQ(walk.nodes, bvh.nodes.size());
        return bvh;
    }
};

// Spheres among the triangles, and one that is larger than all.
void add_spheres(Scene &scene, int count, double radius) {
    std::mt19937 random(23);
    std::uniform_real_distribution<double> within(-1, 1);
    for (int i = 0; i < count; ++i) {
        scene.spheres.push_back({.center = {within(random), within(random), within(random)},
                                 .radius = radius * (1.1 + within(random)),
                                 .where = {}});
    }
    scene.spheres.push_back({.center = {0, -1001, 0}, .radius = 1000, .where = {}});
}

TEST_F(Stage09Bvh, OfNoShapesHasNoNodes) {
    EXPECT_TRUE(build_bvh(soup(0, 1)).nodes.empty());
}

TEST_F(Stage09Bvh, HoldsEveryShapeOnce) {
    for (const int count : {1, 2, 3, 8, 9, 100, 20000}) {
        SCOPED_TRACE(count);
        expect_whole(soup(count, 0.05));
        Scene mixed = soup(count, 0.05);
        add_spheres(mixed, count, 0.05);
        expect_whole(mixed);
        mixed.triangles.clear();
        expect_whole(mixed);
    }
}

TEST_F(Stage09Bvh, OfManyIsNoDeeperThanItNeedsToBe) {
    EXPECT_LT(expect_whole(soup(20000, 0.02)).stack_size, 60);
}

// What a random ray through the root is expected to try, by the surface area heuristic: of each
// child's box its area, times 1 for a node and the number of shapes for a leaf, in areas of the
// root.
double cost_of(const Bvh &bvh) {
    const auto area = [](const device::BvhNode &node, std::size_t child) {
        double size[3];
        for (int axis = 0; axis < 3; ++axis) {
            size[axis] =
                double(node.planes[axis + 3].s[child]) - double(node.planes[axis].s[child]);
        }
        return size[0] < 0 ? 0 : size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    };
    device::BvhNode all{};  // the root's box, as a child
    for (int axis = 0; axis < 3; ++axis) {
        const auto &low = bvh.nodes[0].planes[axis].s, &high = bvh.nodes[0].planes[axis + 3].s;
        all.planes[axis].s[0] = *std::min_element(low, low + 4);
        all.planes[axis + 3].s[0] = *std::max_element(high, high + 4);
    }
    double cost = 0;
    for (const device::BvhNode &node : bvh.nodes) {
        for (std::size_t child = 0; child < 4; ++child) {
            cost += area(node, child) * std::max(1, std::abs(node.count[child]));
        }
    }
    return cost / area(all, 0);
}

// Speed shows in no picture: a tree that is built worse costs more than what stands here, which is
// what was measured.
TEST_F(Stage09Bvh, CostsNoMoreThanItDid) {
    const auto expect_at_most = [](const char *what, const Scene &scene, double cost) {
        EXPECT_LE(cost_of(build_bvh(scene)), 1.005 * cost) << what;
    };
    Scene stretched = soup(2000, 0.05);  // no axis is like another
    for (Vertex &vertex : stretched.vertices) {
        vertex.position *= dvec3(1, 4, 0.25);
    }
    Scene spheres = soup(0, 1);
    add_spheres(spheres, 2000, 0.02);
    spheres.spheres.pop_back();        // the large one
    Scene unequal = soup(1000, 0.01);  // most of it in a corner, and some that is large
    for (Vertex &vertex : unequal.vertices) {
        vertex.position = vertex.position * 0.05 + 0.9;
    }
    const Scene large = soup(200, 0.4);
    const auto first = std::uint32_t(unequal.vertices.size());
    unequal.vertices.insert(unequal.vertices.end(), large.vertices.begin(), large.vertices.end());
    for (Triangle triangle : large.triangles) {
        for (std::uint32_t &vertex : triangle.vertices) {
            vertex += first;
        }
        unequal.triangles.push_back(triangle);
    }
    expect_at_most("stretched", stretched, 10.77);
    expect_at_most("spheres", spheres, 15.81);
    expect_at_most("unequal", unequal, 11.83);
}

TEST_F(Stage09Bvh, DividesShapesInOnePlaceByTheirNumber) {
    Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
    for (int i = 0; i < 10000; ++i) {
        add_flat_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0);
    }
    constexpr int levels = 9;  // 10000 / 8 leaves, and some more
    EXPECT_LE(expect_whole(scene).stack_size, levels * 3 + 1);
}

// Each triangle is three times as far out and as large as the one before: costs alone peel them off
// by ones and twos, 45 deep.
TEST_F(Stage09Bvh, StaysBoundedWhereCostsLeadDeep) {
    Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
    for (int i = 0; i < 80; ++i) {
        const double size = std::pow(3.0, i - 40);
        add_flat_triangle(scene, {size, 0, 0}, {1.5 * size, 0, 0}, {size, 0.5 * size, 0}, 0);
    }
    EXPECT_LE(expect_whole(scene).stack_size, 37);
}

TEST_F(Stage09Bvh, TakesCoordinatesNearTheLargest) {
    Scene scene = soup(1000, 0.1);
    for (Vertex &vertex : scene.vertices) {
        vertex.position *= 3e38;
    }
    expect_whole(scene);
}

TEST_F(Stage09Bvh, IsTheSameEachTime) {
    Scene scene = soup(20000, 0.05);
    add_spheres(scene, 1000, 0.05);
    const Bvh first = build_bvh(scene);
    for (int i = 0; i < 3; ++i) {
        const Bvh again = build_bvh(scene);
        EXPECT_EQ(again.triangles, first.triangles);
        EXPECT_EQ(again.spheres, first.spheres);
        ASSERT_EQ(again.nodes.size(), first.nodes.size());
        EXPECT_EQ(std::memcmp(again.nodes.data(), first.nodes.data(),
                              first.nodes.size() * sizeof(device::BvhNode)),
                  0);
    }
}

// How the tree is walked: by a ray of stage 09, or by so many of stage 10 side by side.
struct Walking {
    const char *device;
    const char *stage;
    const char *width;
};

void PrintTo(const Walking &walking, std::ostream *stream) {
    *stream << walking.device << ' ' << walking.stage << " width " << walking.width;
}

// Drawn with the tree and, by stage 05, without: no pixel sees another shape.
class Picture : public testing::TestWithParam<Walking> {
protected:
    // With the triangles of stage 05, unless the tree's own are wanted.
    static Frame draw(const char *stage, const Scene &scene,
                      const char *triangle = "moeller_trumbore") {
        RenderSettings settings = settings_of(scene);
        settings.methods = {
            {"width", GetParam().width}, {"sphere", "geometric"}, {"triangle", triangle}};
        return Renderer(choose_device(GetParam().device), stage, scene, settings).render();
    }
    static Frame draw_with_tree(const Scene &scene, const char *triangle = "moeller_trumbore") {
        return draw(GetParam().stage, scene, triangle);
    }
    static void expect_same_counts(const RayTotals &is, const RayTotals &expected) {
        EXPECT_EQ(is.primary, expected.primary);
        EXPECT_EQ(is.shadow, expected.shadow);
        EXPECT_EQ(is.reflection, expected.reflection);
        EXPECT_EQ(is.refraction, expected.refraction);
        EXPECT_EQ(is.dropped, expected.dropped);
        EXPECT_EQ(is.cut_off, expected.cut_off);
        EXPECT_EQ(is.cut_off_weight, expected.cut_off_weight);
    }
    // Shadow rays and lines, and rays from wherever a mirror is.
    static void expect_same(Scene scene, const Material &material) {
        scene.width = scene.height = 65;  // so that one ray goes straight ahead
        scene.max_depth = 4;
        add_material(scene, material);  // the first: that of all triangles
        add_directional_light(scene, {0, -1, 0}, {1, 1, 1}, 0.5);
        add_point_light(scene, {0, 3, 4}, {1, 1, 1}, 10);
        const Frame with = draw_with_tree(scene);
        const Frame without = draw("05_meshes", scene);
        int different = 0;
        for (std::size_t i = 0; i < with.image.pixels.size(); ++i) {
            different += glm::distance(with.image.pixels[i], without.image.pixels[i]) > 1e-4F;
        }
        EXPECT_EQ(different, 0) << "of " << with.image.pixels.size() << " pixels";
        expect_same_counts(with.rays, without.rays);
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
std::string name_of(const testing::TestParamInfo<Walking> &walking) {
    return fmt::format("{}_{}", name_in_tests(walking.param.device), walking.param.width);
}

INSTANTIATE_TEST_SUITE_P(Stage09, Picture, testing::ValuesIn([] {
                             std::vector<Walking> walks;
                             for (const char *device : implementations) {
                                 walks.push_back({device, "09_tree", "1"});
                             }
                             return walks;
                         }()),
                         name_of);
// Not on rusticl, whose compiler takes minutes for the wide kernels. (All widths are held to the
// goldens.)
INSTANTIATE_TEST_SUITE_P(Stage10, Picture,
                         testing::Values(Walking{"pocl", "10_packets", "4"},
                                         Walking{"pocl", "10_packets", "16"}),
                         name_of);

TEST_P(Picture, OfManyTrianglesIsThatWithoutATree) {
    expect_same(soup(1500, 0.15), diffuse({1, 1, 1}));
    expect_same(soup(1500, 0.15), mirror({0.9, 0.9, 0.9}));
}

TEST_P(Picture, OfOneAndOfTwoTrianglesToo) {
    expect_same(soup(1, 3), diffuse({1, 1, 1}));
    expect_same(soup(2, 3), diffuse({1, 1, 1}));
}

// One of them is the ground, which most boxes are in; and the eye is in none, or in another.
TEST_P(Picture, OfSpheresAmongTrianglesToo) {
    for (const int triangles : {0, 1, 300}) {
        Scene scene = soup(triangles, 0.15);
        add_spheres(scene, 300, 0.05);
        expect_same(scene, diffuse({1, 1, 1}));
        scene.spheres.push_back({.center = {0, 0, 0}, .radius = 8, .where = {}});
        expect_same(scene, mirror({0.9, 0.9, 0.9}));
    }
}

// Boxes without thickness, rays along the axes, light straight from above along the walls, and an
// eye in the very plane of the triangles' edges.
TEST_P(Picture, OfWallsSeenAlongTheAxesToo) {
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
TEST_P(Picture, HasNoHoleWhereCornersMeet) {
    for (const bool clockwise : {false, true}) {
        Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
        scene.background = {1, 0, 0};
        add_wall(scene, 4, 0, clockwise);
        add_material(scene, diffuse({1, 1, 1}));
        EXPECT_EQ(draw_with_tree(scene, "woop").image.pixels.at(0), glm::vec3(0)) << clockwise;
    }
}

TEST_P(Picture, FromWithinTheSlabsToo) {
    Scene scene = one_pixel({0, 0, 0.5}, {0, 0, -1});
    add_wall(scene, 4, -0.5);
    add_wall(scene, 4, 0.5);
    expect_same(scene, diffuse({1, 1, 1}));
}

// A shadow line ends at its light: neither what is just before it nor what is behind may be taken
// for the other. One of the lights is behind a plane, and reaches nothing that is seen.
TEST_P(Picture, WithALightAmongTheTrianglesToo) {
    Scene scene = soup(1500, 0.15);
    add_plane(scene, {-1, 0, 0}, {0.3, 0, 0}, diffuse({1, 1, 1}));
    add_point_light(scene, {2, 1, 1}, {1, 1, 1}, 5);
    add_point_light(scene, {0.1, 0.05, 0}, {1, 1, 1}, 1);
    add_point_light(scene, {-0.4, 0.3, 0.5}, {1, 1, 1}, 1);
    expect_same(scene, diffuse({1, 1, 1}));
}

// Glass and a mirror, few bounces deep: rays of each kind, and rays that the depth limit drops.
Scene glass_and_mirror() {
    Scene scene = one_pixel({0, 1, 4}, {0, 0.5, 0});
    scene.width = 64;
    scene.height = 40;
    scene.max_depth = 3;
    scene.background = {0.5, 0.6, 0.7};
    add_plane(scene, {0, 1, 0}, {0, 0, 0}, glossy({0.6, 0.6, 0.6}, 0.25));
    add_sphere(scene, {-0.8, 0.7, 0}, 0.7, glass({1, 0.9, 0.8}, 1.5, {0.1, 0.5, 1}));
    add_sphere(scene, {0.7, 0.5, 0.4}, 0.5, glass({1, 1, 1}, 0.75, {}));
    add_sphere(scene, {0.4, 0.8, -1.5}, 0.8, mirror({0.9, 0.9, 0.9}));
    add_point_light(scene, {2, 3, 3}, {1, 1, 1}, 12);
    add_directional_light(scene, {-0.5, -1, -0.8}, {1, 1, 1}, 0.3);
    return scene;
}

TEST_P(Picture, CountsRaysOfEveryKind) {
    const Scene scene = glass_and_mirror();
    const Frame with = draw_with_tree(scene);
    const RayTotals one_by_one = draw("04_refraction_beer", scene).rays;
    expect_same_counts(with.rays, one_by_one);
    EXPECT_GT(one_by_one.shadow, 1000);
    EXPECT_GT(one_by_one.reflection, 500);
    EXPECT_GT(one_by_one.refraction, 500);
    EXPECT_GT(one_by_one.dropped, 100);
}

// Stage 11, which cuts rays off: by packets as with one ray at a time.
TEST(Stage11Counts, OfPacketsAreThoseOfSingleRays) {
    Scene scene = glass_and_mirror();
    scene.max_depth = 12;
    const auto draw = [&](const char *width) {
        RenderSettings settings = settings_of(scene);
        settings.methods = {{"width", width}};
        return Renderer(choose_device(implementations.front()), "11_full_tracer", scene, settings)
            .render()
            .rays;
    };
    const RayTotals single = draw("1");
    const RayTotals packets = draw("4");
    EXPECT_EQ(packets.shadow, single.shadow);
    EXPECT_EQ(packets.reflection, single.reflection);
    EXPECT_EQ(packets.refraction, single.refraction);
    EXPECT_EQ(packets.dropped, single.dropped);
    EXPECT_EQ(packets.cut_off, single.cut_off);
    // The weights are products, rounded one way or the other.
    EXPECT_NEAR(packets.cut_off_weight, single.cut_off_weight, 1e-3 * single.cut_off_weight);
    EXPECT_GT(single.cut_off, 100);
    EXPECT_GT(single.cut_off_weight, 0);
}

TEST_P(Picture, OfAnyScaleToo) {
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
