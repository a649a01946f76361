// SPDX-License-Identifier: MIT
// The tree of boxes: that it holds every triangle once, in boxes that hold it, and that what is
// drawn with it is what is drawn by trying all triangles.
#include <cmath>
#include <limits>
#include <random>

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
    // Follows all ways down, and counts how often each triangle is met.
    struct Walk {
        const Scene &scene;
        const Bvh &bvh;
        std::vector<int> met = std::vector<int>(bvh.order.size());
        int depth = 0;
        std::size_t nodes = 0;

        void into(std::uint32_t node, int at_depth) {
            depth = std::max(depth, at_depth);
            ++nodes;
            for (const device::BvhChild &child : bvh.nodes.at(node).children) {
                if (child.count == 0 && child.low[0] < std::numeric_limits<float>::infinity()) {
                    ASSERT_GT(child.first, node) << "a node comes before its children";
                    expect_within(child);
                    into(child.first, at_depth + 1);
                } else {
                    leaf(child);
                }
            }
        }
        void leaf(const device::BvhChild &child) {
            ASSERT_LE(child.count, 8);
            for (std::uint32_t i = child.first; i < child.first + child.count; ++i) {
                ++met.at(bvh.order.at(i));
                for (const std::uint32_t vertex : scene.triangles[bvh.order[i]].vertices) {
                    const glm::vec3 at(scene.vertices[vertex].position);
                    for (int axis = 0; axis < 3; ++axis) {
                        EXPECT_TRUE(child.low[axis] <= at[axis] && at[axis] <= child.high[axis]);
                    }
                }
            }
        }
        // The children's boxes are in their parent's.
        void expect_within(const device::BvhChild &parent) const {
            for (const device::BvhChild &child : bvh.nodes.at(parent.first).children) {
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_TRUE(parent.low[axis] <= child.low[axis]
                                && child.high[axis] <= parent.high[axis]);
                }
            }
        }
    };

    static Bvh expect_whole(const Scene &scene) {
        Bvh bvh = build_bvh(scene);
        Walk walk{scene, bvh};
        walk.into(0, 1);
        EXPECT_EQ(walk.met, std::vector<int>(scene.triangles.size(), 1));
        EXPECT_EQ(walk.depth, bvh.depth);
        EXPECT_EQ(walk.nodes, bvh.nodes.size());
        return bvh;
    }
};

TEST_F(Stage09Bvh, OfNoTrianglesHasNoNodes) {
    const Bvh bvh = build_bvh(soup(0, 1));
    EXPECT_TRUE(bvh.nodes.empty());
    EXPECT_EQ(bvh.depth, 0);
}

TEST_F(Stage09Bvh, HoldsEveryTriangleOnce) {
    for (const int count : {1, 2, 3, 8, 9, 100, 20000}) {
        SCOPED_TRACE(count);
        expect_whole(soup(count, 0.05));
    }
}

TEST_F(Stage09Bvh, OfManyIsNoDeeperThanItNeedsToBe) {
    EXPECT_LT(expect_whole(soup(20000, 0.02)).depth, 30);
}

TEST_F(Stage09Bvh, DividesTrianglesInOnePlaceByTheirNumber) {
    Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
    for (int i = 0; i < 10000; ++i) {
        add_flat_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0);
    }
    EXPECT_LE(expect_whole(scene).depth, 12) << "10000 / 8 leaves, by halves";
}

// Each triangle is three times as far out and as large as the one before: costs alone peel them off
// by ones and twos, 45 deep.
TEST_F(Stage09Bvh, StaysBoundedWhereCostsLeadDeep) {
    Scene scene = one_pixel({0, 0, 4}, {0, 0, 0});
    for (int i = 0; i < 80; ++i) {
        const double size = std::pow(3.0, i - 40);
        add_flat_triangle(scene, {size, 0, 0}, {1.5 * size, 0, 0}, {size, 0.5 * size, 0}, 0);
    }
    EXPECT_LE(expect_whole(scene).depth, 37);
}

TEST_F(Stage09Bvh, TakesCoordinatesNearTheLargest) {
    Scene scene = soup(1000, 0.1);
    for (Vertex &vertex : scene.vertices) {
        vertex.position *= 3e38;
    }
    expect_whole(scene);
}

TEST_F(Stage09Bvh, IsTheSameEachTime) {
    const Scene scene = soup(20000, 0.05);
    const Bvh first = build_bvh(scene);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(build_bvh(scene).order, first.order);
    }
}

// Drawn with the tree and, by stage 05, without: not a bit differs.
class Stage09Picture : public OnEachDevice {
protected:
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
            different += with.image.pixels[i] != without.image.pixels[i];
        }
        EXPECT_EQ(different, 0) << "of " << with.image.pixels.size() << " pixels";
        EXPECT_EQ(with.rays.shadow, without.rays.shadow);
        EXPECT_EQ(with.rays.reflection, without.rays.reflection);
        EXPECT_GT(with.rays.shadow + with.rays.reflection, 100) << "what was seen?";
    }

    // A wall of 2 n^2 triangles at z, from -1 to 1, whose edges are along the axes.
    static void add_wall(Scene &scene, int n, double z) {
        const double step = 2.0 / n;
        for (int i = 0; i < n * n; ++i) {
            const dvec3 corner(-1 + step * (i % n), -1 + step * (i / n), z);
            const dvec3 right = corner + dvec3(step, 0, 0);
            const dvec3 up = corner + dvec3(0, step, 0);
            add_flat_triangle(scene, corner, right, up, 0);
            add_flat_triangle(scene, right, up + dvec3(step, 0, 0), up, 0);
        }
    }
};
INSTANTIATE_TEST_SUITE_P(Devices, Stage09Picture, each_device(), device_name);

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

TEST_P(Stage09Picture, FromWithinTheSlabsToo) {
    Scene scene = one_pixel({0, 0, 0.5}, {0, 0, -1});
    add_wall(scene, 4, -0.5);
    add_wall(scene, 4, 0.5);
    expect_same(scene, diffuse({1, 1, 1}));
}

// A shadow line ends at its light: neither what is just before it nor what is behind may be taken
// for the other.
TEST_P(Stage09Picture, WithALightAmongTheTrianglesToo) {
    Scene scene = soup(1500, 0.15);
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
