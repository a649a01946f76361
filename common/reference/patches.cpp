// SPDX-License-Identifier: MIT
#include "reference/patches.h"

#include <array>
#include <cstddef>
#include <map>

namespace stagelight::reference {

namespace {

using Corner = std::array<double, 12>;

Corner corner_of(const Scene &scene, const Triangle &triangle, std::size_t index) {
    const Vertex &vertex = scene.vertices[triangle.vertices[index]];
    const bool textured = scene.materials[std::size_t(triangle.material)].texture != no_texture;
    const glm::dvec2 uv = textured ? vertex.texture_coordinates : glm::dvec2(0);
    return {vertex.position.x,
            vertex.position.y,
            vertex.position.z,
            vertex.normal.x,
            vertex.normal.y,
            vertex.normal.z,
            uv.x,
            uv.y,
            vertex.color.x,
            vertex.color.y,
            vertex.color.z,
            double(triangle.material)};
}

// Disjoint sets of triangles (Galler and Fischer, An Improved Equivalence Algorithm, 1964).
class Sets {
public:
    explicit Sets(std::size_t count) : parents_(count) {
        for (std::size_t i = 0; i < count; ++i)
            parents_[i] = int(i);
    }
    int find(int member) {
        while (parent(member) != member)
            member = parent(member) = parent(parent(member));
        return member;
    }
    void join(int one, int other) { parent(find(one)) = find(other); }

private:
    int &parent(int member) { return parents_[std::size_t(member)]; }
    std::vector<int> parents_;
};

}  // namespace

std::vector<int> smooth_patches(const Scene &scene) {
    Sets sets(scene.triangles.size());
    std::map<Corner, int> seen;  // the first triangle with that corner
    std::vector<int> patches(scene.triangles.size());
    for (std::size_t i = 0; i < patches.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
            sets.join(int(i), seen.try_emplace(corner_of(scene, scene.triangles[i], corner), int(i))
                                  .first->second);
    for (std::size_t i = 0; i < patches.size(); ++i)
        patches[i] = sets.find(int(i));
    return patches;
}

}  // namespace stagelight::reference
