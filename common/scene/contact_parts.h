// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scene/box_tree.h"
#include "scene/scene.h"

namespace stagelight {

// The connected parts of all meshes. Their triangles don't touch each other, they join; so a part
// is all that shares corners, by position. Glass parts share edges: two cubes of glass may stand
// corner to corner, and touch.
class ContactParts {
public:
    explicit ContactParts(const Scene &scene);

    // Of each triangle the number of its part, in the order of their first triangles.
    std::uint32_t part(std::uint32_t triangle) const { return parts_[triangle]; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(boxes_.size()); }
    std::span<const std::uint32_t> triangles(std::uint32_t part) const {
        return std::span(by_part_).subspan(first_of_[part], first_of_[part + 1] - first_of_[part]);
    }
    const std::vector<Box> &boxes() const { return boxes_; }
    bool has_several_materials(std::uint32_t part) const { return several_materials_[part]; }
    // The first triangle of this one's part that has its material; 0 where the part has but one.
    std::uint32_t first_of_material(std::uint32_t triangle) const;

    std::uint32_t place(std::uint32_t vertex) const { return places_[vertex]; }

    // Whether each edge has an even number of triangles, so that the part is a solid.
    bool is_closed(std::uint32_t part) const;

private:
    void number_parts(std::vector<std::uint32_t> &root);
    void sort_by_part();

    const Scene &scene_;
    std::vector<std::uint32_t> places_;
    std::vector<std::uint32_t> parts_;
    std::vector<std::uint32_t> by_part_;   // triangles
    std::vector<std::uint32_t> first_of_;  // of each part its first in by_part_, and the end
    std::vector<Box> boxes_;
    std::vector<bool> several_materials_;
    std::map<std::pair<std::uint32_t, int>, std::uint32_t> first_of_material_;
    mutable std::vector<std::optional<bool>> closed_;  // once asked for
};

}  // namespace stagelight
