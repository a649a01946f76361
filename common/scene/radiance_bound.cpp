// SPDX-License-Identifier: MIT
#include "scene/radiance_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stagelight {
namespace {

double largest(const glm::dvec3 &v) {
    return std::max({v.x, v.y, v.z});
}

double distance_to(const Scene &, const Sphere &sphere, const glm::dvec3 &point) {
    return std::abs(glm::distance(point, sphere.center) - sphere.radius);
}

double distance_to(const Scene &, const Plane &plane, const glm::dvec3 &point) {
    return std::abs(glm::dot(point - plane.point, plane.normal));
}

// Or less: no point of a triangle is nearer than its plane, nor than its box.
double distance_to(const Scene &scene, const Triangle &triangle, const glm::dvec3 &point) {
    const auto corner = [&](std::size_t i) {
        return scene.vertices[triangle.vertices[i]].position;
    };
    const glm::dvec3 a = corner(0), b = corner(1), c = corner(2);
    const glm::dvec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    const double to_box = glm::distance(point, glm::clamp(point, low, high));
    const glm::dvec3 facing = glm::normalize(glm::cross(b - a, c - a));
    return std::max(to_box, std::abs(glm::dot(point - a, facing)));
}

// Of what is lit at all.
double distance_to_surfaces(const Scene &scene, const glm::dvec3 &point) {
    double nearest = std::numeric_limits<double>::infinity();
    const auto ask = [&](const auto &shapes) {
        for (const auto &shape : shapes) {
            const MaterialType type =
                scene.materials[static_cast<std::size_t>(shape.material)].type;
            if (type == MaterialType::diffuse || type == MaterialType::glossy) {
                nearest = std::min(nearest, distance_to(scene, shape, point));
            }
        }
    };
    ask(scene.spheres);
    ask(scene.planes);
    ask(scene.triangles);
    return nearest;
}

// docs/shading.md, "Light", at the distance where it is strongest.
glm::dvec3 strongest(const Scene &scene, const Light &light) {
    const glm::dvec3 power = light.color * light.intensity;
    if (light.type == LightType::directional) {
        return power;
    }
    const double distance = distance_to_surfaces(scene, light.position);
    const double window = std::max(0.0, 1 - std::pow(distance / light.range, 4));
    return power * (window * window / (distance * distance));
}

}  // namespace

double radiance_bound(const Scene &scene) {
    glm::dvec3 lit(0);
    for (const Light &light : scene.lights) {
        lit += strongest(scene, light);
    }
    return std::max(largest(scene.background), largest(lit));
}

}  // namespace stagelight
