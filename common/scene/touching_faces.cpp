// SPDX-License-Identifier: MIT
#include "scene/touching_faces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "scene/normalize.h"
#include "scene/rounding.h"

namespace stagelight {
namespace {

// Faces that turn away from each other more than this are not flat upon each other, however small.
constexpr double least_cosine = 0.9;

glm::dvec3 extent(const FlatFace &face) {
    return glm::max(glm::abs(face.corners[0]),
                    glm::max(glm::abs(face.corners[1]), glm::abs(face.corners[2])));
}

// How far two triangles in one plane reach into each other, at least: the shortest way that would
// part them is at a right angle to one of their edges.
double overlap(const TriangleCorners &a, const TriangleCorners &b, const glm::dvec3 &normal) {
    double least = std::numeric_limits<double>::infinity();
    for (const TriangleCorners *triangle : {&a, &b}) {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 axis =
                normalize(glm::cross(normal, (*triangle)[(i + 1) % 3] - (*triangle)[i]));
            const auto along = [&](const TriangleCorners &of) {
                return std::minmax(
                    {glm::dot(axis, of[0]), glm::dot(axis, of[1]), glm::dot(axis, of[2])});
            };
            const auto [a_low, a_high] = along(a);
            const auto [b_low, b_high] = along(b);
            least = std::min(least, std::min(a_high, b_high) - std::max(a_low, b_low));
        }
    }
    return least;
}

class Finder {
public:
    Finder(const Scene &scene, const ContactParts &parts) : scene_(scene), parts_(parts) {}

    std::vector<Touch> find() {
        for (const Plane &plane : scene_.planes) {
            try_plane(plane);
        }
        std::vector<std::uint32_t> near = near_others();
        std::vector<Box> boxes;
        for (const std::uint32_t i : near) {
            faces_.emplace_back(scene_, scene_.triangles[i]);
            boxes.push_back(padded_box(i));
        }
        const BoxTree tree(boxes);
        for (std::uint32_t i = 0; i < near.size(); ++i) {
            tree.each(boxes[i], [&](std::uint32_t other) {
                if (other < i) {
                    try_pair(near[other], faces_[other], near[i], faces_[i]);
                }
            });
        }
        return std::move(touches_);
    }

private:
    Box padded_box(std::uint32_t triangle) const {
        const TriangleCorners corners = corners_of(scene_, scene_.triangles[triangle]);
        const Box box = box_of(corners);
        return box.padded(touching * std::max(largest_coordinate(box), farthest_of(corners)));
    }

    double farthest_of(const TriangleCorners &corners) const {
        return std::max({glm::distance(corners[0], scene_.camera.position),
                         glm::distance(corners[1], scene_.camera.position),
                         glm::distance(corners[2], scene_.camera.position)});
    }

    // Those that may touch another part, or others of their own. Parts are told by their boxes, and
    // where those meet, by boxes of a few triangles that follow each other: in most files, they are
    // near each other too.
    std::vector<std::uint32_t> near_others() const {
        std::vector<Box> of_parts;
        for (std::uint32_t part = 0; part < parts_.count(); ++part) {
            const Box &box = parts_.boxes()[part];
            const double farthest =
                glm::length(glm::max(glm::abs(box.low - scene_.camera.position),
                                     glm::abs(box.high - scene_.camera.position)));
            of_parts.push_back(box.padded(touching * std::max(largest_coordinate(box), farthest)));
        }
        const BoxTree parts_tree(of_parts);
        std::vector<std::uint32_t> close;
        std::vector<Box> runs;
        std::vector<std::uint32_t> part_of_run;
        for (std::uint32_t part = 0; part < parts_.count(); ++part) {
            if (parts_.has_several_materials(part)
                || parts_tree.any(of_parts[part],
                                  [&](std::uint32_t other) { return other != part; })) {
                const auto triangles = parts_.triangles(part);
                const std::size_t few = std::min<std::size_t>(1 + triangles.size() / 256, 32);
                for (std::size_t i = 0; i < triangles.size(); ++i) {
                    if (i % few == 0) {
                        runs.emplace_back();
                        part_of_run.push_back(part);
                    }
                    runs.back().add(padded_box(triangles[i]));
                }
                close.push_back(part);
            }
        }
        const BoxTree runs_tree(runs);
        std::vector<std::uint32_t> near;
        for (const std::uint32_t part : close) {
            for (const std::uint32_t triangle : parts_.triangles(part)) {
                if (parts_.has_several_materials(part)
                    || runs_tree.any(padded_box(triangle),
                                     [&](std::uint32_t run) { return part_of_run[run] != part; })) {
                    near.push_back(triangle);
                }
            }
        }
        return near;
    }

    // Whether the face lies in the plane; if so, the heights of its corners.
    static bool lies_in_plane(const FlatFace &face, const glm::dvec3 &normal,
                              const glm::dvec3 &base, double scale, double &least, double &most) {
        const auto above = [&](std::size_t i) { return glm::dot(normal, face.corners[i] - base); };
        std::tie(least, most) = std::minmax({above(0), above(1), above(2)});
        return std::abs(glm::dot(normal, face.normal)) > least_cosine
               && std::max(-least, most) <= touching * scale;
    }

    void try_plane(const Plane &plane) {
        const double offset = glm::dot(glm::abs(plane.normal), glm::abs(plane.point));
        const int index = static_cast<int>(&plane - scene_.planes.data());
        for (std::uint32_t i = 0; i < scene_.triangles.size(); ++i) {
            const TriangleCorners corners = corners_of(scene_, scene_.triangles[i]);
            const glm::dvec3 above = corners[0] - plane.point;
            const double farthest = farthest_of(corners);
            if (std::abs(glm::dot(plane.normal, above))
                > 2 * touching * (offset + farthest + glm::length(scene_.camera.position))) {
                continue;  // for most; the rest asks for more
            }
            const FlatFace face(scene_, scene_.triangles[i]);
            Touch touch{.later = i, .plane = index};
            touch.scale = std::max(rounding_scale(face, plane.normal), offset);
            double least = 0, most = 0;
            if (lies_in_plane(face, plane.normal, plane.point, touch.scale, least, most)) {
                const bool is_along = glm::dot(plane.normal, face.normal) > 0;
                touch.least_gap = is_along ? least : -most;
                touch.most_gap = is_along ? most : -least;
                touches_.push_back(touch);
            }
        }
    }

    void try_pair(std::uint32_t a, const FlatFace &of_a, std::uint32_t b, const FlatFace &of_b) {
        if (parts_.part(a) == parts_.part(b)
            && scene_.triangles[a].material == scene_.triangles[b].material) {
            return;
        }
        if (of_a.area > of_b.area) {
            return try_pair(b, of_b, a, of_a);
        }
        const FlatFace &small = of_a, &large = of_b;
        const double scale = std::max(rounding_scale(small, large.normal),
                                      glm::dot(glm::abs(large.normal), extent(large)));
        double least = 0, most = 0;
        if (!lies_in_plane(small, large.normal, large.corners[0], scale, least, most)
            || overlap(small.corners, large.corners, large.normal) <= touching * scale) {
            return;
        }
        const bool is_small_later = later_of(a, b) == a;
        Touch touch{.later = is_small_later ? a : b, .earlier = is_small_later ? b : a};
        touch.scale = scale;
        const bool is_along = is_small_later && glm::dot(small.normal, large.normal) > 0;
        touch.least_gap = is_along ? least : -most;
        touch.most_gap = is_along ? most : -least;
        touches_.push_back(touch);
    }

    std::uint32_t later_of(std::uint32_t a, std::uint32_t b) const {
        const auto order = [&](std::uint32_t triangle) {
            return std::pair(parts_.part(triangle), parts_.first_of_material(triangle));
        };
        return order(a) > order(b) ? a : b;
    }

    const Scene &scene_;
    const ContactParts &parts_;
    std::vector<FlatFace> faces_;  // of those near others
    std::vector<Touch> touches_;
};

}  // namespace

FlatFace::FlatFace(const Scene &scene, const Triangle &triangle)
    : corners(corners_of(scene, triangle)) {
    const glm::dvec3 cross = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    glm::dvec3 side(0);
    for (const std::uint32_t vertex : triangle.vertices) {
        side += scene.vertices[vertex].normal;
        farthest = std::max(farthest,
                            glm::distance(scene.camera.position, scene.vertices[vertex].position));
    }
    normal = normalize(glm::dot(cross, side) < 0 ? -cross : cross);
    area = 0.5 * glm::length(cross);
}

double rounding_scale(const FlatFace &face, const glm::dvec3 &normal) {
    return std::max(glm::dot(glm::abs(normal), extent(face)), face.farthest);
}

std::vector<Touch> touching_faces(const Scene &scene, const ContactParts &parts) {
    return Finder(scene, parts).find();
}

}  // namespace stagelight
