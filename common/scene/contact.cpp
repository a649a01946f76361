// SPDX-License-Identifier: MIT
#include "scene/contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/box_tree.h"
#include "scene/contact_margin.h"
#include "scene/dielectrics.h"
#include "scene/face_contacts.h"

namespace stagelight {
namespace {

bool look_the_same(const Scene &scene, int a, int b) {
    return a == b && !is_dielectric(scene, a);
}

// How far each plane is moved along its normal.
std::vector<double> raised_planes(const Scene &scene) {
    std::vector<double> raised(scene.planes.size());
    for (std::size_t i = 0; i < scene.planes.size(); ++i) {
        const Plane &plane = scene.planes[i];
        const double nearest =
            std::abs(glm::dot(plane.normal, scene.camera.position - plane.point));
        const double scale =
            std::max(glm::dot(glm::abs(plane.normal), glm::abs(plane.point)), nearest);
        for (std::size_t j = 0; j < i; ++j) {
            const Plane &earlier = scene.planes[j];
            const double gap = glm::dot(plane.normal, plane.point - earlier.point);
            if (glm::length(glm::cross(plane.normal, earlier.normal)) <= touching
                && std::abs(gap) <= touching * scale
                && !look_the_same(scene, plane.material, earlier.material)) {
                raised[i] = std::max(raised[i], raised[j] * glm::dot(plane.normal, earlier.normal)
                                                    - gap + contact_margin(scene, scale, nearest));
            }
        }
    }
    return raised;
}

void grow_equal_spheres(Scene &scene) {
    std::vector<Box> boxes;
    for (const Sphere &sphere : scene.spheres) {
        boxes.push_back(Box{sphere.center, sphere.center});
    }
    const BoxTree tree(boxes);
    std::vector<double> radii;  // as the file has them
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        Sphere &sphere = scene.spheres[i];
        radii.push_back(sphere.radius);
        const double to_center = glm::distance(sphere.center, scene.camera.position);
        const double scale =
            std::max({largest_coordinate(sphere.center), sphere.radius, to_center + sphere.radius});
        const double margin = contact_margin(scene, scale, std::abs(to_center - sphere.radius));
        tree.each(boxes[i].padded(touching * scale), [&](std::uint32_t other) {
            const Sphere &earlier = scene.spheres[other];
            if (other < i && std::abs(radii[other] - radii[i]) <= touching * scale
                && !look_the_same(scene, sphere.material, earlier.material)) {
                sphere.radius = std::max(sphere.radius, earlier.radius + margin);
            }
        });
    }
}

}  // namespace

void settle_contacts(Scene &scene) {
    const std::vector<double> raised = raised_planes(scene);
    if (!scene.triangles.empty()) {
        move_touching_faces(scene, raised);
    }
    for (std::size_t i = 0; i < raised.size(); ++i) {
        if (raised[i] > 0) {  // a sum with 0 would be another -0
            scene.planes[i].point += raised[i] * scene.planes[i].normal;
        }
    }
    grow_equal_spheres(scene);
}

}  // namespace stagelight
