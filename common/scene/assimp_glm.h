// SPDX-License-Identifier: MIT
// Assimp's vectors and matrices as GLM's.
#pragma once

#include <assimp/matrix4x4.h>
#include <assimp/vector3.h>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace stagelight {

inline glm::dvec3 to_glm(const aiVector3D &v) {
    return {v.x, v.y, v.z};
}

inline aiVector3D to_assimp(const glm::dvec3 &v) {
    return {static_cast<ai_real>(v.x), static_cast<ai_real>(v.y), static_cast<ai_real>(v.z)};
}

// Assimp writes matrices row by row, GLM column by column.
inline glm::dmat4 to_glm(const aiMatrix4x4 &m) {
    return glm::transpose(glm::dmat4(m.a1, m.a2, m.a3, m.a4,  //
                                     m.b1, m.b2, m.b3, m.b4,  //
                                     m.c1, m.c2, m.c3, m.c4,  //
                                     m.d1, m.d2, m.d3, m.d4));
}

}  // namespace stagelight
