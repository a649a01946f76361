// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <assimp/DefaultIOSystem.h>

#include "scene/mesh_notes.h"

namespace stagelight {

// Without its point, in lower case.
std::string file_extension(const std::filesystem::path &file);

// What Assimp has asked for while it read a file.
struct AssimpFiles {
    bool has_read_failed = false;                // a read has given less than the file has
    std::vector<std::filesystem::path> folders;  // the file's own, and those of others it has named
    std::string missing_materials;               // the first .mtl that is named and is not there
};

// Files for Assimp, some of whose readers take what a failing disk has given for all there is, and
// others read what they should not as it stands: see obj_input.h, mtl_input.h, gltf_input.h and
// ply_input.h. What `file` names is found in any letter case and with its %20 decoded.
class CheckedIOSystem : public Assimp::IOSystem {
public:
    // Throws std::invalid_argument, with what was expected, for a file of a kind that can't be read
    // right.
    CheckedIOSystem(std::filesystem::path file, MeshNotes &notes, AssimpFiles &asked);

    bool Exists(const char *file) const override;
    char getOsSeparator() const override { return files_.getOsSeparator(); }
    Assimp::IOStream *Open(const char *file, const char *mode) override;
    void Close(Assimp::IOStream *file) override { files_.Close(file); }
    bool ComparePaths(const char *one, const char *second) const override {
        return files_.ComparePaths(one, second);
    }

private:
    std::filesystem::path find(const std::filesystem::path &file) const;
    std::string read(const std::string &file);
    void prepare(const std::filesystem::path &file);
    const std::string *prepared(const std::string &file) const;

    Assimp::DefaultIOSystem files_;  // not a base: Assimp 6 has it final
    std::filesystem::path file_;
    MeshNotes &notes_;
    AssimpFiles &asked_;
    bool is_obj_ = false;
    std::map<std::string, std::string> prepared_;  // what stands in for files, by their path
};

}  // namespace stagelight
