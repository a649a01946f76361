// SPDX-License-Identifier: MIT
// What Assimp makes of a mesh file, checked and prepared for import.
#pragma once

#include <filesystem>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include "scene/assimp_io.h"
#include "scene/scene.h"

namespace stagelight {

// Every aiMesh has triangles, with finite positions, normals, and indices within it; v goes
// down the image.
class MeshFile {
public:
    // Throws UserError at `where` for a file that Assimp can't make such meshes from.
    MeshFile(const std::filesystem::path &file, const SourceLocation &where);

    const aiScene &scene() const { return *importer_.GetScene(); }
    const AssimpFiles &files() const { return files_; }

private:
    AssimpFiles files_;  // before the importer, which holds a reference to it
    Assimp::Importer importer_;
};

}  // namespace stagelight
