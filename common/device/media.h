// SPDX-License-Identifier: MIT
// The dielectrics of a scene as the kernels tell them apart where they meet (kernels/media.cl).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/bodies.h"
#include "scene/scene.h"

namespace stagelight {

// A bit for each medium, in order of precedence: where several hold a point, the highest is there.
// Bodies of one material that never meet share one.
class Media {
public:
    Media() = default;
    // With the bodies that meet others, hold the eye, or absorb light that never comes out of them,
    // a half-space's; or where the eye will move, with all: none in most scenes. Of more than 32
    // media, warns and leaves out those of the lowest precedence.
    Media(const Scene &scene, bool eye_moves);

    // Of each medium, lowest first, its index into Scene::materials.
    const std::vector<int> &materials() const { return materials_; }
    // The medium of a sphere, plane or triangle; -1 for what takes part in none.
    int of_sphere(std::size_t index) const { return medium_of(bodies_.of_sphere, index); }
    int of_plane(std::size_t index) const { return medium_of(bodies_.of_plane, index); }
    int of_triangle(std::size_t index) const { return medium_of(bodies_.of_triangle, index); }

    // The bits of those that hold a point of the scene.
    std::uint32_t at(const Scene &scene, const glm::dvec3 &point) const;

private:
    int medium_of(const std::vector<int> &of_shape, std::size_t index) const {
        return materials_.empty() || of_shape[index] < 0
                   ? -1
                   : of_body_[static_cast<std::size_t>(of_shape[index])];
    }

    Bodies bodies_;
    std::vector<int> materials_;
    std::vector<int> of_body_;  // -1: of no medium
};

}  // namespace stagelight
