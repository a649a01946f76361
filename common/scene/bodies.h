// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>
#include "scene/scene.h"
namespace stagelight {
struct Body { int material = 0; double volume = 0; };
struct Bodies {
    std::vector<Body> list;
    std::vector<int> of_sphere, of_plane, of_triangle;
    std::vector<std::pair<int, int>> meeting;
    std::vector<std::string> warnings;
};
Bodies bodies_of(const Scene &scene);
std::vector<int> bodies_at(const Scene &scene, const Bodies &bodies, const glm::dvec3 &point);
}  // namespace stagelight
