// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "scene/contact_parts.h"
#include "scene/scene.h"
#include "scene/touching_faces.h"

namespace stagelight {

// The direction in which the later of two faces that touch is moved; none if it can stay, since
// nobody can tell which is in front.
std::optional<glm::dvec3> side_of_later(const Scene &scene, const ContactParts &parts,
                                        const Touch &touch);

}  // namespace stagelight
