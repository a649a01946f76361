// SPDX-License-Identifier: MIT
// What Assimp makes of a mesh file, checked and prepared for import.
#pragma once

#include <filesystem>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include "scene/assimp_io.h"
#include "scene/mesh_notes.h"
#include "scene/scene.h"

namespace stagelight {

// Every aiMesh has triangles, with finite positions, normals, and indices within it; v goes
// down the image. Joints are in the pose that the file's nodes are in, y is up.
class MeshFile {
public:
    // Throws UserError at `where` for a file that Assimp can't make such meshes from.
    MeshFile(const std::filesystem::path &file, const SourceLocation &where);

    const aiScene &scene() const { return *importer_.GetScene(); }
    const AssimpFiles &files() const { return files_; }

    // What the file has beside that.
    const MeshNotes &notes() const { return notes_; }

private:
    void prepare();
    void note_what_is_lost();

    AssimpFiles files_;  // before the importer, which holds references to them
    MeshNotes notes_;
    Assimp::Importer importer_;
};

}  // namespace stagelight
