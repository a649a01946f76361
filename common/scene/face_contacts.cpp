// SPDX-License-Identifier: MIT
#include "scene/face_contacts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "scene/contact_margin.h"
#include "scene/contact_parts.h"
#include "scene/contact_side.h"
#include "scene/touching_faces.h"

namespace stagelight {
namespace {

// A vertex is to move in this direction, at least so far.
struct Push {
    glm::dvec3 direction;
    double distance;
};

// Directions that are the same count once; those of a smooth surface nearly do, and those of a
// cube's corner add up.
glm::dvec3 sum_of(const std::vector<Push> &pushes) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        const bool is_new = std::none_of(
            pushes.begin(), pushes.begin() + std::ptrdiff_t(i), [&](const Push &other) {
                return glm::dot(other.direction, pushes[i].direction) > 1 - 1e-9;
            });
        sum += is_new ? pushes[i].direction : glm::dvec3(0);
    }
    const glm::dvec3 direction =
        glm::length(sum) > 0.1 ? glm::normalize(sum) : pushes.front().direction;
    double distance = 0;  // never back
    for (const Push &push : pushes) {
        constexpr double least_cosine = 0.25;  // at a sharp edge it would go far
        distance = std::max(
            distance, push.distance / std::max(glm::dot(direction, push.direction), least_cosine));
    }
    return distance * direction;
}

class FaceContacts {
public:
    FaceContacts(Scene &scene, const std::vector<double> &raised)
        : scene_(scene), raised_(raised), parts_(scene) {}

    void settle() {
        // In the order of what is moved, so that what it touches has been moved before.
        std::map<Group, std::vector<Touch>> of_group;
        for (const Touch &touch : touching_faces(scene_, parts_)) {
            const std::uint32_t part = parts_.part(touch.later);
            const bool is_within = touch.plane < 0 && parts_.part(touch.earlier) == part;
            of_group[{part, is_within ? parts_.first_of_material(touch.later) : whole_part}]
                .push_back(touch);
        }
        for (const auto &[group, touches] : of_group) {
            std::map<std::uint32_t, std::vector<Push>> pushes;  // of each place
            for (const Touch &touch : touches) {
                add(pushes, touch);
            }
            for (const auto &[place, all] : pushes) {
                moved_[group].emplace(place, sum_of(all));
            }
        }
        if (!moved_.empty()) {
            apply();
        }
    }

private:
    // What moves together: a part; or of a part what is of one material, by its first triangle,
    // where that touches another material of the part. The first material is never the later one.
    using Group = std::pair<std::uint32_t, std::uint32_t>;
    static constexpr std::uint32_t whole_part = 0;
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    glm::dvec3 moved(std::uint32_t triangle, std::size_t corner) const {
        const std::uint32_t part = parts_.part(triangle);
        const std::uint32_t place = parts_.place(scene_.triangles[triangle].vertices[corner]);
        const auto of = [&](const Group &group) {
            const auto places = moved_.find(group);
            if (places == moved_.end()) {
                return glm::dvec3(0);
            }
            const auto found = places->second.find(place);
            return found == places->second.end() ? glm::dvec3(0) : found->second;
        };
        const std::uint32_t material = parts_.first_of_material(triangle);
        return of({part, whole_part})
               + (material == whole_part ? glm::dvec3(0) : of({part, material}));
    }

    void add(std::map<std::uint32_t, std::vector<Push>> &pushes, const Touch &touch) const {
        const std::optional<glm::dvec3> direction = side_of_later(scene_, parts_, touch);
        if (!direction) {
            return;
        }
        double before = -std::numeric_limits<double>::infinity();  // how far the earlier one went
        double own = -before;
        for (std::size_t i = 0; i < 3; ++i) {
            before = std::max(
                before,
                touch.plane >= 0
                    ? raised_[static_cast<std::size_t>(touch.plane)]
                          * glm::dot(scene_.planes[static_cast<std::size_t>(touch.plane)].normal,
                                     *direction)
                    : glm::dot(moved(touch.earlier, i), *direction));
            own = std::min(own, glm::dot(moved(touch.later, i), *direction));
        }
        const Triangle &triangle = scene_.triangles[touch.later];
        const FlatFace face(scene_, triangle);
        const glm::dvec3 &eye = scene_.camera.position;
        const double gap =
            glm::dot(face.normal, *direction) > 0 ? touch.least_gap : -touch.most_gap;
        const double distance =
            before - own - gap
            + contact_margin(scene_, touch.scale,
                             glm::distance(eye, closest_point(face.corners, eye)));
        for (const std::uint32_t vertex : triangle.vertices) {
            pushes[parts_.place(vertex)].push_back({*direction, distance});
        }
    }

    // A vertex that parts share is copied.
    void apply() {
        std::vector<std::uint32_t> owner(scene_.vertices.size(), none);
        std::vector<bool> is_shared(scene_.vertices.size());
        for (std::uint32_t i = 0; i < scene_.triangles.size(); ++i) {
            for (const std::uint32_t vertex : scene_.triangles[i].vertices) {
                is_shared[vertex] =
                    is_shared[vertex] || (owner[vertex] != none && owner[vertex] != parts_.part(i));
                owner[vertex] = parts_.part(i);
            }
        }
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> moved_vertices;
        // Only then, since a vertex that has been added has no place.
        std::map<std::uint32_t, std::array<std::uint32_t, 3>> to;
        for (std::uint32_t i = 0; i < scene_.triangles.size(); ++i) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const glm::dvec3 by = moved(i, corner);
                if (by == glm::dvec3(0)) {
                    continue;
                }
                to.emplace(i, scene_.triangles[i].vertices);
                const std::uint32_t vertex = scene_.triangles[i].vertices[corner];
                const auto [known, is_new] =
                    moved_vertices.emplace(std::pair(vertex, parts_.part(i)), vertex);
                if (is_new && is_shared[vertex]) {
                    known->second = static_cast<std::uint32_t>(scene_.vertices.size());
                    scene_.vertices.push_back(Vertex(scene_.vertices[vertex]));
                }
                if (is_new) {
                    scene_.vertices[known->second].position += by;
                }
                to[i][corner] = known->second;
            }
        }
        for (const auto &[triangle, vertices] : to) {
            scene_.triangles[triangle].vertices = vertices;
        }
    }

    Scene &scene_;
    const std::vector<double> &raised_;
    const ContactParts parts_;
    std::map<Group, std::map<std::uint32_t, glm::dvec3>> moved_;  // of each place
};

}  // namespace

void move_touching_faces(Scene &scene, const std::vector<double> &raised) {
    FaceContacts(scene, raised).settle();
}

}  // namespace stagelight
