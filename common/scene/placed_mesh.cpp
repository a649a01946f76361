// SPDX-License-Identifier: MIT
#include "scene/placed_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/vector_relational.hpp>

#include "scene/assimp_glm.h"
#include "scene/normalize.h"
#include "scene/validators.h"

namespace stagelight {

namespace {

bool is_finite(const glm::dvec3 &v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_direction(const glm::dvec3 &v) {
    return is_finite(v) && v != glm::dvec3(0);
}

// At right angles to the triangle, not of unit length; zero if it has no area but for rounding.
glm::dvec3 perpendicular(const std::array<glm::dvec3, 3> &corners) {
    const glm::dvec3 b = corners[1] - corners[0];
    const glm::dvec3 c = corners[2] - corners[0];
    const glm::dvec3 cross = glm::cross(b, c);
    const double longest = std::max({glm::dot(b, b), glm::dot(c, c), glm::dot(c - b, c - b)});
    return glm::dot(cross, cross) > 1e-24 * longest * longest ? cross : glm::dvec3(0);
}

// What makes a vertex the same as another. Assimp's JoinIdenticalVertices also joins some that
// are less than 1e-5 apart, which is all of a mesh that is small enough.
using Key = std::array<float, 11>;

Key key_of(const aiVector3D &position, const aiVector3D &normal, const aiVector3D &uv,
           const aiColor4D &color) {
    Key key{position.x, position.y, position.z, normal.x, normal.y, normal.z,
            uv.x,       uv.y,       color.r,    color.g,  color.b};
    std::transform(key.begin(), key.end(), key.begin(), [](float v) { return v + 0.0F; });  // no -0
    return key;
}

// Of all but the colour, which seldom differs by itself.
struct KeyHash {
    std::size_t operator()(const Key &key) const {
        return std::hash<std::string_view>()(
            {reinterpret_cast<const char *>(key.data()), 8 * sizeof(float)});
    }
};

// IEC 61966-2-1.
double linear_of_srgb(double value) {
    return value > 0.04045 ? std::pow((value + 0.055) / 1.055, 2.4) : value / 12.92;
}

class PlacedMesh {
public:
    PlacedMesh(Scene &scene, const aiMesh &mesh, const glm::dmat4 &to_world, const Look &look)
        : scene_(scene), mesh_(mesh), to_world_(to_world),
          normals_to_world_(glm::inverseTranspose(glm::dmat3(to_world))),
          is_mirrored_(glm::determinant(glm::dmat3(to_world)) < 0), look_(look) {}

    bool append() {
        for (const aiFace &face : std::span(mesh_.mFaces, mesh_.mNumFaces)) {
            if (face.mNumIndices == 3 && !append(face)) {
                return false;
            }
        }
        return true;
    }

private:
    bool append(const aiFace &face) {
        std::array corners{face.mIndices[0], face.mIndices[1], face.mIndices[2]};
        if (is_mirrored_) {  // or the front would become the back
            std::swap(corners[1], corners[2]);
        }
        std::array<glm::dvec3, 3> positions;
        for (std::size_t i = 0; i < 3; ++i) {
            positions[i] = to_world_ * glm::dvec4(to_glm(mesh_.mVertices[corners[i]]), 1);
            if (!is_finite(positions[i])) {
                return false;
            }
        }
        if (const glm::dvec3 facing = perpendicular(positions); is_direction(facing)) {
            Triangle triangle{.material = look_.material,
                              .mesh = static_cast<int>(scene_.meshes.size()) - 1};
            for (std::size_t i = 0; i < 3; ++i) {
                triangle.vertices[i] = vertex(corners[i], positions[i], facing);
            }
            scene_.triangles.push_back(triangle);
        }
        return true;
    }

    // #region shared_vertex
    // Shared by the triangles that use it; `facing` serves where the file's normal is no direction.
    std::uint32_t vertex(unsigned index, const glm::dvec3 &position, const glm::dvec3 &facing) {
        const aiVector3D uv = coordinates(index);
        const aiColor4D color = look_.has_colors ? mesh_.mColors[0][index] : aiColor4D(1, 1, 1, 1);
        const auto [known, is_new] =
            index_of_.try_emplace(key_of(mesh_.mVertices[index], mesh_.mNormals[index], uv, color),
                                  static_cast<std::uint32_t>(scene_.vertices.size()));
        if (is_new) {
            const glm::dvec3 normal = normals_to_world_ * to_glm(mesh_.mNormals[index]);
            scene_.vertices.push_back({.position = position,
                                       .normal = normalize(is_direction(normal) ? normal : facing),
                                       .texture_coordinates = glm::dvec2(
                                           look_.texture_transform * glm::dvec3(uv.x, uv.y, 1)),
                                       .color = linear(color)});
        }
        return known->second;
    }
    // #endregion shared_vertex

    // As three.js, we take colours for sRGB but in glTF, which says that they are linear.
    glm::dvec3 linear(const aiColor4D &color) const {
        const auto channel = [&](float value) {
            const double within = std::isfinite(value) ? std::clamp(double{value}, 0.0, 1.0) : 0.0;
            return look_.are_colors_linear ? within : linear_of_srgb(within);
        };
        return {channel(color.r), channel(color.g), channel(color.b)};
    }

    aiVector3D coordinates(unsigned index) const {
        if (!mesh_.HasTextureCoords(look_.coordinates)) {
            return {};
        }
        const aiVector3D uv = mesh_.mTextureCoords[look_.coordinates][index];
        return is_finite(to_glm(uv)) ? uv : aiVector3D();
    }

    Scene &scene_;
    const aiMesh &mesh_;
    glm::dmat4 to_world_;
    glm::dmat3 normals_to_world_;
    bool is_mirrored_;
    Look look_;
    std::unordered_map<Key, std::uint32_t, KeyHash> index_of_;
};

}  // namespace

bool append_placed(Scene &scene, const aiMesh &mesh, const glm::dmat4 &to_world, const Look &look) {
    return PlacedMesh(scene, mesh, to_world, look).append();
}

bool append_copy(Scene &scene, const MeshModel &model, const glm::dmat4 &to_world,
                 const std::optional<int> &material) {
    const glm::dmat3 normals_to_world = glm::inverseTranspose(glm::dmat3(to_world));
    const bool is_mirrored = glm::determinant(glm::dmat3(to_world)) < 0;
    const std::size_t first = scene.vertices.size();
    scene.vertices.insert(scene.vertices.end(), model.vertices.begin(), model.vertices.end());
    for (Vertex &vertex : std::span(scene.vertices).subspan(first)) {
        vertex.position = to_world * glm::dvec4(vertex.position, 1);
        vertex.normal = normalize(normals_to_world * vertex.normal);
        if (!glm::all(glm::lessThanEqual(glm::abs(vertex.position), glm::dvec3(largest_number)))) {
            return false;
        }
    }
    for (Triangle triangle : model.triangles) {
        std::array<glm::dvec3, 3> positions;
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.vertices[i] += static_cast<std::uint32_t>(first);
            positions[i] = scene.vertices[triangle.vertices[i]].position;
        }
        if (is_mirrored) {
            std::swap(triangle.vertices[1], triangle.vertices[2]);
            std::swap(positions[1], positions[2]);
        }
        const glm::dvec3 facing = perpendicular(positions);
        if (!is_direction(facing)) {
            continue;
        }
        for (const std::uint32_t vertex : triangle.vertices) {
            if (!is_direction(scene.vertices[vertex].normal)) {
                scene.vertices[vertex].normal = normalize(facing);
            }
        }
        triangle.material = material.value_or(triangle.material);
        triangle.mesh = static_cast<int>(scene.meshes.size()) - 1;
        scene.triangles.push_back(triangle);
    }
    return true;
}

}  // namespace stagelight
