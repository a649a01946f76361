// SPDX-License-Identifier: MIT
// Which flat faces lie in the same place.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/contact_parts.h"
#include "scene/mesh_surface.h"
#include "scene/scene.h"

namespace stagelight {

// A triangle as contact sees it.
struct FlatFace {
    FlatFace(const Scene &scene, const Triangle &triangle);

    TriangleCorners corners;
    glm::dvec3 normal;  // unit length, on the side of the vertices' normals
    double area = 0;
    double farthest = 0;  // corner from the camera
};

// How far rounding may move what is measured along `normal` to these corners, as the camera sees
// them, in units of float_rounding.
double rounding_scale(const FlatFace &face, const glm::dvec3 &normal);

struct Touch {
    std::uint32_t later;        // index into Scene::triangles
    int plane = -1;             // what it touches: a plane,
    std::uint32_t earlier = 0;  // or another triangle
    // How far the later one lies above it, along its own normal, at least and at most.
    double least_gap = 0, most_gap = 0;
    double scale = 0;  // rounding_scale of both
};

// Triangles that overlap a plane or each other in area and lie within `touching` of it. Triangles
// of one part don't, unless their materials differ. The later one is in the later part, or of one
// part, has the material that comes later in it.
std::vector<Touch> touching_faces(const Scene &scene, const ContactParts &parts);

}  // namespace stagelight
