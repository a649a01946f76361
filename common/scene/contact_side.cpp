// SPDX-License-Identifier: MIT
#include "scene/contact_side.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <glm/geometric.hpp>

#include "scene/dielectrics.h"

namespace stagelight {
namespace {

bool have_same_corners(const Scene &scene, const ContactParts &parts, std::uint32_t a,
                       std::uint32_t b) {
    const auto places = [&](std::uint32_t triangle) {
        const auto &vertices = scene.triangles[triangle].vertices;
        std::array found{parts.place(vertices[0]), parts.place(vertices[1]),
                         parts.place(vertices[2])};
        std::ranges::sort(found);
        return found;
    };
    return places(a) == places(b);
}

// What lies on the other side of an opaque surface than the camera is seen by no ray, if the
// surface is a plane or a solid.
struct Surface {
    glm::dvec3 normal;
    glm::dvec3 point;
    int material;
    bool is_plane;
    bool is_solid;
};

// Of a cut-out, what is behind is seen through it.
bool is_solid_at(const Scene &scene, const ContactParts &parts, std::uint32_t triangle) {
    const int material = scene.triangles[triangle].material;
    return parts.is_closed(parts.part(triangle))
           && !has_cutout(scene.materials[static_cast<std::size_t>(material)]);
}

Surface earlier_of(const Scene &scene, const ContactParts &parts, const Touch &touch) {
    if (touch.plane >= 0) {
        const Plane &plane = scene.planes[static_cast<std::size_t>(touch.plane)];
        return {plane.normal, plane.point, plane.material, true, false};
    }
    const Triangle &triangle = scene.triangles[touch.earlier];
    const FlatFace face(scene, triangle);
    return {face.normal, face.corners[0], triangle.material, false,
            is_solid_at(scene, parts, touch.earlier)};
}

}  // namespace

std::optional<glm::dvec3> side_of_later(const Scene &scene, const ContactParts &parts,
                                        const Touch &touch) {
    const Triangle &triangle = scene.triangles[touch.later];
    const FlatFace later(scene, triangle);
    const Surface earlier = earlier_of(scene, parts, touch);
    if (is_dielectric(scene, triangle.material) || is_dielectric(scene, earlier.material)) {
        return later.normal;
    }
    if (triangle.material == earlier.material && !earlier.is_plane
        && have_same_corners(scene, parts, touch.later, touch.earlier)) {
        return std::nullopt;
    }
    // Within a part they are the two sides of a sheet, or a picture on it.
    const bool is_one_part =
        !earlier.is_plane && parts.part(touch.later) == parts.part(touch.earlier);
    if (is_one_part || glm::dot(later.normal, earlier.normal) > 0) {
        return later.normal;
    }
    const bool is_solid = is_solid_at(scene, parts, touch.later);
    const auto is_seen = [&](const glm::dvec3 &normal) {
        return glm::dot(normal, scene.camera.position - earlier.point) > 0;
    };
    if (is_solid) {  // stands on it, front to front
        return earlier.is_solid || is_seen(earlier.normal) ? std::nullopt
                                                           : std::optional(later.normal);
    }
    if (earlier.is_solid) {  // stands on this one, if that's where the camera is
        return is_seen(later.normal) ? std::nullopt : std::optional(earlier.normal);
    }
    // A sheet upon a plane is never pushed to where the plane hides it. Of two sheets each shows on
    // its own side.
    return earlier.is_plane && is_seen(earlier.normal) ? earlier.normal : later.normal;
}

}  // namespace stagelight
