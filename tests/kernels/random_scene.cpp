// SPDX-License-Identifier: MIT
#include "kernels/random_scene.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec3;
using reference::Dice;

dvec3 floats(const dvec3 &v) {
    return dvec3(vec3(v));
}

double as_float(double v) {
    return double(float(v));
}

void add_random_sphere(Scene &scene, Dice &dice) {
    const dvec3 center = floats(dice.in_cube(4));
    reference::add_sphere(scene, center, as_float(dice.between(0.3, 1.5)),
                          reference::diffuse({1, 1, 1}));
}

// Along an axis, so that its offset is a float as well.
void add_plane_across(Scene &scene, int axis, double side) {
    dvec3 normal(0);
    normal[axis] = side;
    reference::add_plane(scene, normal, -6.0 * normal, reference::diffuse({1, 1, 1}));
}

void add_random_triangle(Scene &scene, Dice &dice) {
    const dvec3 middle = dice.in_cube(4);
    std::array<Vertex, 3> corners;
    for (Vertex &corner : corners) {
        corner.position = floats(middle + dice.in_cube(2));
        corner.texture_coordinates = glm::dvec2(floats(dice.in_cube(3)));
    }
    const dvec3 facet = glm::normalize(glm::cross(corners[1].position - corners[0].position,
                                                  corners[2].position - corners[0].position));
    const double side = dice.between(-1, 1) < 0 ? -1 : 1;  // wound this way or that
    for (Vertex &corner : corners) {
        corner.normal = floats(glm::normalize(side * facet + 0.7 * dice.direction()));
    }
    Material material = reference::diffuse({1, 1, 1});
    material.texture = 0;
    reference::add_triangle(scene, corners[0], corners[1], corners[2],
                            reference::add_material(scene, material));
}

}  // namespace

Scene random_scene(Dice &dice, const RandomScene &with) {
    Scene scene;
    for (int i = 0; i < 6; ++i) {
        add_random_sphere(scene, dice);
    }
    add_plane_across(scene, 1, 1);
    add_plane_across(scene, 2, -1);
    if (with.triangles) {
        scene.textures.push_back(reference::texture_of(1, 1, {255, 255, 255, 255}));
        for (int i = 0; i < 12; ++i) {
            add_random_triangle(scene, dice);
        }
    }
    if (with.point_lights) {
        reference::add_point_light(scene, floats(dice.in_cube(5)), {1, 0.5, 0.25}, 8);
        reference::add_point_light(scene, scene.spheres[0].center, {0.25, 1, 0.5}, 16);
        scene.lights[1].range = 8;
    }
    if (with.directional_light) {
        reference::add_directional_light(scene, floats(dice.direction()), {0.5, 0.25, 1}, 2);
    }
    return scene;
}

SceneNeeds needs_for(const RandomScene &with, int stage) {
    Dice dice;
    return needs_of(random_scene(dice, with), stage, 8);
}

}  // namespace stagelight
