// SPDX-License-Identifier: MIT
#include "bench/generated_scenes.h"
#include "bench/stages.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stagelight::bench {
namespace {

struct Bounds {
    glm::dvec3 low{1e9}, high{-1e9};
};

Bounds bounds_of(const Scene &scene) {
    Bounds bounds;
    for (const Vertex &vertex : scene.vertices) {
        bounds.low = glm::min(bounds.low, vertex.position);
        bounds.high = glm::max(bounds.high, vertex.position);
    }
    return bounds;
}

TEST(GeneratedScenes, RingHasAsManyTrianglesAsItSays) {
    for (const int n : {3, 16, 64}) {
        const Scene scene = ring(n);
        EXPECT_EQ(scene.triangles.size(), static_cast<std::size_t>(4 * n * n));
        EXPECT_EQ(scene.vertices.size(), static_cast<std::size_t>(2 * n * n)) << "it is closed";
    }
}

TEST(GeneratedScenes, RingKeepsItsShape) {
    const Bounds coarse = bounds_of(ring(16));
    const Bounds fine = bounds_of(ring(256));
    EXPECT_LT(glm::distance(coarse.low, fine.low), 0.03);
    EXPECT_LT(glm::distance(coarse.high, fine.high), 0.03);
}

// Corners counter-clockwise seen from outside, and normals that lead there.
TEST(GeneratedScenes, RingFacesOutwards) {
    const Scene scene = ring(32);
    for (const Triangle &triangle : scene.triangles) {
        const auto &[a, b, c] = triangle.vertices;
        const auto at = [&](std::uint32_t i) { return scene.vertices[i].position; };
        const glm::dvec3 facet = glm::cross(at(b) - at(a), at(c) - at(a));
        const glm::dvec3 middle = glm::normalize(glm::dvec3(at(a).x, 0, at(a).z));
        EXPECT_GT(glm::dot(facet, at(a) - middle), 0);
        EXPECT_GT(glm::dot(scene.vertices[a].normal, at(a) - middle), 0);
    }
}

TEST(GeneratedScenes, LightsAddUpToAsMuch) {
    for (const int count : {1, 8, 64}) {
        const Scene scene = ring_in_lights(count);
        ASSERT_EQ(scene.lights.size(), static_cast<std::size_t>(count));
        EXPECT_DOUBLE_EQ(scene.lights[0].intensity * count, 25);
    }
}

TEST(GeneratedScenes, MirrorsFaceEachOther) {
    const Scene scene = facing_mirrors(12);
    EXPECT_EQ(settings_of(full_tracer(), scene).max_depth, 12);
    ASSERT_EQ(scene.planes.size(), 2U);
    EXPECT_EQ(scene.planes[0].normal, -scene.planes[1].normal);
    for (const Plane &plane : scene.planes) {
        EXPECT_GT(glm::dot(plane.normal, scene.camera.position - plane.point), 0);
    }
}

}  // namespace
}  // namespace stagelight::bench
