// SPDX-License-Identifier: MIT
// Scenes of another size, or elsewhere, that look the same.
#pragma once

#include "scene/scene.h"

namespace stagelight::render {

// Every point through `place`; all else by the factor that lengths are multiplied by.
template <typename Place> Scene moved(Scene scene, double scale, Place place) {
    const auto move = [&](glm::dvec3 &point) { point = place(point); };
    move(scene.camera.position);
    move(scene.camera.look_at);
    for (Sphere &sphere : scene.spheres) {
        move(sphere.center);
        sphere.radius *= scale;
    }
    for (Plane &plane : scene.planes) {
        move(plane.point);
    }
    for (Vertex &vertex : scene.vertices) {
        move(vertex.position);
    }
    for (Light &light : scene.lights) {
        move(light.position);
        light.range *= scale;
        light.intensity *= light.type == LightType::point ? scale * scale : 1;
    }
    for (Material &material : scene.materials) {
        material.absorption /= scale;
    }
    return scene;
}

inline Scene scaled(const Scene &scene, double scale) {
    return moved(scene, scale, [scale](glm::dvec3 point) { return scale * point; });
}

inline Scene shifted(const Scene &scene, glm::dvec3 offset) {
    return moved(scene, 1, [offset](glm::dvec3 point) { return point + offset; });
}

}  // namespace stagelight::render
