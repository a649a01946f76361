// SPDX-License-Identifier: MIT
// Scenes of surfaces that touch, and what has been moved in them.
#pragma once

#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/glass_meshes.h"
#include "scene/glass_shapes.h"

namespace stagelight {

// What a mesh or plane is moved by, where the camera is 5 to 8 away.
constexpr double least = 64 * 0x1p-24 * 4, most = 64 * 0x1p-24 * 9;

inline const std::string square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
inline const std::string forwards = square + "f 1 2 3\nf 1 3 4\n";  // towards the camera
inline const std::string backwards = square + "f 1 3 2\nf 1 4 3\n";

class ContactScenes : public GlassShapes {
protected:
    // The positions of the corners of a mesh's triangles, in their order.
    static std::vector<glm::dvec3> corners_of_mesh(const Scene &scene, int mesh) {
        std::vector<glm::dvec3> found;
        for (const Triangle &triangle : scene.triangles) {
            if (triangle.mesh == mesh) {
                for (const std::uint32_t vertex : triangle.vertices) {
                    found.push_back(scene.vertices[vertex].position);
                }
            }
        }
        return found;
    }

    // How far the corners of mesh `index` are from where they are in a scene of this mesh only.
    std::vector<glm::dvec3> moves(const std::string &shapes, int index,
                                  const std::string &mesh_only) const {
        const auto is = corners_of_mesh(load(shapes), index);
        auto all = corners_of_mesh(load(mesh_only), 0);
        EXPECT_EQ(is.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = is[i] - all[i];
        }
        return all;
    }

    static void expect_still(const std::vector<glm::dvec3> &moves) {
        for (const glm::dvec3 &move : moves) {
            ASSERT_EQ(move, glm::dvec3(0));
        }
    }

    // Along `direction`, and no other way.
    static void expect_moved(const std::vector<glm::dvec3> &moves, const glm::dvec3 &direction,
                             double times = 1) {
        for (const glm::dvec3 &move : moves) {
            ASSERT_GT(glm::dot(move, direction), times * least);
            ASSERT_LT(glm::dot(move, direction), times * most);
            ASSERT_LT(glm::length(move - glm::dot(move, direction) * direction), 1e-15);
        }
    }

    void SetUp() override {
        folder.write("cube.obj", cube(false));
        folder.write("front.obj", forwards);
        folder.write("back.obj", backwards);
    }
};

}  // namespace stagelight
