// SPDX-License-Identifier: MIT
// Meshes for tests of glass, as OBJ files.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/mesh_surface.h"
#include "scene/scene_file.h"
#include "scene/temporary_folder.h"

namespace stagelight {

// Twelve triangles, outwards, on corners that follow each other as these do.
inline const std::vector<std::array<int, 3>> cube_faces{{4, 3, 2}, {4, 2, 1}, {5, 6, 7}, {5, 7, 8},
                                                        {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6},
                                                        {3, 4, 8}, {3, 8, 7}, {4, 1, 5}, {4, 5, 8}};

inline std::string corners(const glm::dvec3 &center, const glm::dvec3 &half) {
    const glm::dvec3 low = center - half, high = center + half;
    std::string text;
    for (const double z : {low.z, high.z}) {
        text += fmt::format("v {0} {2} {4}\nv {1} {2} {4}\nv {1} {3} {4}\nv {0} {3} {4}\n", low.x,
                            high.x, low.y, high.y, z);
    }
    return text;
}

inline std::string face(const std::array<int, 3> &f, bool inwards, int first = 0) {
    return fmt::format("f {} {} {}\n", first + f[0], first + f[inwards ? 2 : 1],
                       first + f[inwards ? 1 : 2]);
}

inline std::string faces(bool inwards, int first = 0) {
    std::string text;
    for (const auto &f : cube_faces) {
        text += face(f, inwards, first);
    }
    return text;
}

inline std::string cube(bool inwards, const glm::dvec3 &center = {0, 0, 0},
                        const glm::dvec3 &half = {1, 1, 1}, int first = 0) {
    return corners(center, half) + faces(inwards, first);
}

// On three corners of a cube of edge 1 and the fourth between them.
inline const std::string pyramid = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                   "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

// With normals in the file: those of the faces, times `sign`.
inline std::string cube_with_normals(bool inwards, int sign) {
    std::string text = corners({0, 0, 0}, {1, 1, 1});
    for (const glm::ivec3 &normal : std::vector<glm::ivec3>{
             {0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}) {
        text += fmt::format("vn {} {} {}\n", sign * normal.x, sign * normal.y, sign * normal.z);
    }
    for (std::size_t i = 0; i < cube_faces.size(); ++i) {
        const auto &[a, b, c] = cube_faces[i];
        text += fmt::format("f {1}//{0} {2}//{0} {3}//{0}\n", i / 2 + 1, a, inwards ? c : b,
                            inwards ? b : c);
    }
    return text;
}

// A ball of 2 * 12 * 22 triangles without normals of its own; triangle `turned` the other way
// round.
inline std::string ball(int turned = -1) {
    constexpr int rows = 12, columns = 24;
    std::string text;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double latitude = std::numbers::pi * row / rows;
            const double longitude = 2 * std::numbers::pi * column / columns;
            text +=
                fmt::format("v {:.6f} {:.6f} {:.6f}\n", std::sin(latitude) * std::sin(longitude),
                            std::cos(latitude), std::sin(latitude) * std::cos(longitude));
        }
    }
    int count = 0;
    const auto add = [&](int a, int b, int c) {
        text += face({a + 1, b + 1, c + 1}, count++ == turned);
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int next = (column + 1) % columns;
            const int upper = columns * row, lower = upper + columns;
            if (row > 0) {
                add(upper + column, lower + next, upper + next);
            }
            if (row < rows - 1) {
                add(upper + column, lower + column, lower + next);
            }
        }
    }
    return text;
}

// Each face the other way round.
inline std::string reversed(const std::string &obj) {
    std::string text;
    std::istringstream lines(obj);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string f, a, b, c;
        words >> f >> a >> b >> c;
        text += (f == "f" ? fmt::format("f {} {} {}", a, c, b) : line) + '\n';
    }
    return text;
}

// A pyramid with smooth normals, times `sign`, one of which points beneath a facet.
inline std::string leaning(int sign) {
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    for (const glm::ivec3 &normal :
         std::vector<glm::ivec3>{{-5, 1, -5}, {3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}}) {
        text += fmt::format("vn {} {} {}\n", sign * normal.x, sign * normal.y, sign * normal.z);
    }
    return text + "f 1//1 3//3 2//2\nf 1//1 2//2 4//4\nf 2//2 3//3 4//4\nf 3//3 1//1 4//4\n";
}

class GlassMesh : public testing::Test {
protected:
    Scene load(const std::string &obj, const std::string &placing = "",
               const std::string &type = "dielectric") const {
        folder.write("a.obj", obj);
        return load_scene(folder.write(
            "scene.toml", "[camera]\nposition = [0, 0, 5]\nlook_at = [0, 0, 0]\n[materials.a]\n"
                          "type = \""
                              + type + "\"\n[[meshes]]\nfile = \"a.obj\"\nmaterial = \"a\"\n"
                              + placing));
    }
    TemporaryFolder folder;
};

inline double volume_of(const Scene &scene) {
    double volume = 0;
    for (const Triangle &triangle : scene.triangles) {
        const auto [a, b, c] = corners_of(scene, triangle);
        volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return volume;
}

// No normal of a vertex is on the other side than that of its triangle.
inline void expect_agreeing_normals(const Scene &scene) {
    for (const Triangle &triangle : scene.triangles) {
        const auto [a, b, c] = corners_of(scene, triangle);
        for (const std::uint32_t vertex : triangle.vertices) {
            ASSERT_GT(glm::dot(scene.vertices[vertex].normal, glm::cross(b - a, c - a)), 0);
        }
    }
}

inline void expect_same(const Scene &scene, const Scene &other) {
    ASSERT_EQ(scene.vertices.size(), other.vertices.size());
    for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
        ASSERT_EQ(scene.vertices[i].position, other.vertices[i].position);
        ASSERT_EQ(scene.vertices[i].normal, other.vertices[i].normal);
    }
    ASSERT_EQ(scene.triangles.size(), other.triangles.size());
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        ASSERT_EQ(scene.triangles[i].vertices, other.triangles[i].vertices);
    }
}

}  // namespace stagelight
