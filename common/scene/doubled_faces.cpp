// SPDX-License-Identifier: MIT
#include "scene/doubled_faces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "scene/dielectrics.h"
#include "scene/places.h"

namespace stagelight {
namespace {

struct Face {
    std::array<std::uint32_t, 3> places;  // ascending
    std::uint32_t triangle;
};

std::vector<Face> faces_of(const Scene &scene, const std::vector<std::uint32_t> &places,
                           std::span<const std::uint32_t> triangles) {
    std::vector<Face> faces;
    for (const std::uint32_t triangle : triangles) {
        const auto &vertices = scene.triangles[triangle].vertices;
        Face face{{places[vertices[0]], places[vertices[1]], places[vertices[2]]}, triangle};
        std::ranges::sort(face.places);
        faces.push_back(face);
    }
    std::ranges::sort(faces, {},
                      [](const Face &face) { return std::pair(face.places, face.triangle); });
    return faces;
}

// A face that is there an even number of times may be a wall between two parts. It is one where it
// would leave an odd number of faces at an edge. Faces that share an edge decide together.
class Walls {
public:
    // Of each face its places, and whether it is there an even number of times.
    Walls(const std::vector<std::array<std::uint32_t, 3>> &faces, const std::vector<bool> &even)
        : region_(faces.size()), votes_(faces.size()) {
        std::iota(region_.begin(), region_.end(), 0u);
        struct Side {
            std::uint32_t low, high, face;
        };
        std::vector<Side> sides;
        for (std::uint32_t i = 0; i < faces.size(); ++i) {
            const auto &[a, b, c] = faces[i];
            sides.insert(sides.end(), {{a, b, i}, {b, c, i}, {a, c, i}});
        }
        std::ranges::sort(sides, {}, [](const Side &side) {
            return std::array{side.low, side.high, side.face};
        });
        const auto for_each_edge = [&](const auto &visit) {
            for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
                while (last < sides.size() && sides[last].low == sides[first].low
                       && sides[last].high == sides[first].high) {
                    ++last;
                }
                std::vector<std::uint32_t> doubled;
                for (std::size_t i = first; i < last; ++i) {
                    if (even[sides[i].face]) {
                        doubled.push_back(sides[i].face);
                    }
                }
                if (!doubled.empty()) {
                    visit(doubled, last - first);
                }
            }
        };
        for_each_edge([&](const std::vector<std::uint32_t> &doubled, std::size_t) {
            for (const std::uint32_t face : doubled) {
                region_[root(face)] = root(doubled.front());
            }
        });
        for_each_edge([&](const std::vector<std::uint32_t> &doubled, std::size_t all) {
            if (doubled.size() < all) {
                votes_[root(doubled.front())] += all % 2 == 1 && doubled.size() % 2 == 1 ? 1 : -1;
            }
        });
    }

    bool is_wall(std::uint32_t face) { return votes_[root(face)] > 0; }

private:
    std::uint32_t root(std::uint32_t face) {
        while (region_[face] != face) {
            face = region_[face] = region_[region_[face]];
        }
        return face;
    }

    std::vector<std::uint32_t> region_;
    std::vector<int> votes_;
};

// Marks what is to be dropped of a mesh.
void mark_doubled(std::vector<bool> &dropped, const std::vector<Face> &faces) {
    std::vector<std::array<std::uint32_t, 3>> distinct;
    std::vector<bool> even;
    std::vector<std::uint32_t> first_of;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (i == 0 || faces[i].places != faces[i - 1].places) {
            distinct.push_back(faces[i].places);
            even.push_back(false);
            first_of.push_back(faces[i].triangle);
        } else {
            even.back() = !even.back();
            dropped[faces[i].triangle] = true;
        }
    }
    if (distinct.size() == faces.size()) {
        return;
    }
    Walls walls(distinct, even);
    for (std::uint32_t i = 0; i < distinct.size(); ++i) {
        if (even[i] && walls.is_wall(i)) {
            dropped[first_of[i]] = true;
        }
    }
}

}  // namespace

void drop_doubled_faces(Scene &scene) {
    std::vector<std::uint32_t> places;
    std::vector<bool> dropped(scene.triangles.size());
    for (const std::vector<std::uint32_t> &triangles : dielectric_triangles(scene)) {
        if (!triangles.empty()) {
            if (places.empty()) {
                places = places_of(scene.vertices);
            }
            mark_doubled(dropped, faces_of(scene, places, triangles));
        }
    }
    std::size_t index = 0;
    std::erase_if(scene.triangles, [&](const Triangle &) { return dropped[index++]; });
}

}  // namespace stagelight
