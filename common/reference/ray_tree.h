// SPDX-License-Identifier: MIT
// What the rays of a pixel met, and whether two pixels met the same.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace stagelight::reference {

// What a ray hit: nothing, a sphere or a plane by its index in the scene, or a smooth patch of
// a mesh (patches.h).
struct Surface {
    enum class Kind { none, sphere, plane, patch };
    Kind kind = Kind::none;
    int index = 0;
    bool operator==(const Surface &) const = default;
};

// A light as a hit sees it. Unlit is what faces away or lies out of range: light fades to
// nothing there without a jump.
enum class Shadow : std::uint8_t { unlit, lit, blocked };

struct RayTree {
    Surface surface{};
    bool from_behind = false;
    glm::dvec3 point{0};
    glm::dvec3 shading_normal{0};
    glm::dvec3 geometric_normal{0};
    std::vector<Shadow> shadows{};    // one a light, where lights are asked
    double weight = 0;                // its largest share in a channel of the pixel
    std::vector<RayTree> children{};  // reflected, then transmitted, as far as there are
};

// Below this weight a branch can't move a pixel by the tolerance of 1/255, even when it flips.
constexpr double least_weight = 1e-3;

// True when there is an edge between two neighbouring pixels.
bool differ(const RayTree &one, const RayTree &other);

// Which neighbours of a pixel differ from it.
enum Seam : std::uint8_t { no_seam = 0, seam_right = 1, seam_below = 2 };

// One byte a pixel: 1 within the 3x3 around a pixel beside a seam.
std::vector<std::uint8_t> edge_mask(int width, int height, const std::vector<std::uint8_t> &seams);

}  // namespace stagelight::reference
