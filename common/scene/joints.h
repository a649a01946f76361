// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/scene.h>

namespace stagelight {

// Bends each mesh that has joints into the pose that the nodes are in: a vertex goes where the
// weighted sum of node transform times offset (aiBone) takes it, and its normal with it. Such
// meshes then hang on the root, for their own node has no say any more. False if a joint has no
// node, which leaves a mesh as it was.
bool pose_by_joints(const aiScene &scene);

}  // namespace stagelight
