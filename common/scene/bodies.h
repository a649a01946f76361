// SPDX-License-Identifier: MIT
// The dielectric bodies of a scene: where each lies, and which of them fills a place that several
// hold.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

// A dielectric sphere, the half-space beneath a dielectric plane (its normal points out of it), or
// a connected part of a dielectric mesh with its cavities.
struct Body {
    int material = 0;
    double volume = 0;  // infinite for a half-space
    SourceLocation where;
    int sphere = -1;                         // index into Scene::spheres, or -1
    int plane = -1;                          // index into Scene::planes, or -1
    std::vector<std::uint32_t> triangles{};  // indices into Scene::triangles, ascending
    std::vector<std::uint32_t> shells{};     // of these the first of each connected part
    bool is_closed = true;                   // no edge of it is without a second triangle
};

struct Bodies {
    // In order of precedence: of two that hold a point, the later one is what is there. By
    // priority, then the smaller one comes later, then the one further down in the file.
    std::vector<Body> list;
    // For each shape of the scene its body's index in `list`, or -1 where it is no dielectric.
    std::vector<int> of_sphere, of_plane, of_triangle;
    // Two that share a point: they overlap, touch, or one contains the other. The lesser index
    // first; ascending.
    std::vector<std::pair<int, int>> meeting;
    // One line for each body that can't be seen, since one of a higher priority contains it.
    std::vector<std::string> warnings;
};

Bodies bodies_of(const Scene &scene);

// The bodies that hold the point, their indices ascending: the last is what is there. Where that
// can't be told, since the point lies on a surface or the body has holes, one line a body is
// appended to `warnings`, which calls the point the eye. A surface holds no point.
std::vector<int> bodies_at(const Scene &scene, const Bodies &bodies, const glm::dvec3 &point,
                           std::vector<std::string> *warnings = nullptr);

}  // namespace stagelight
