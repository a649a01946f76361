// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <assimp/DefaultIOSystem.h>

namespace stagelight {

// What Assimp has asked for while it read a file.
struct AssimpFiles {
    bool has_read_failed = false;                // a read has given less than the file has
    std::vector<std::filesystem::path> folders;  // the file's own, and those of others it has named
    std::string missing_materials;               // the first .mtl that is named and is not there
};

// Files for Assimp, some of whose readers take what a failing disk has given for all there is. What
// `file` names is found in any letter case and with its %20 decoded.
class CheckedIOSystem : public Assimp::IOSystem {
public:
    CheckedIOSystem(std::filesystem::path file, AssimpFiles &asked);

    bool Exists(const char *file) const override { return files_.Exists(file); }
    char getOsSeparator() const override { return files_.getOsSeparator(); }
    Assimp::IOStream *Open(const char *file, const char *mode) override;
    void Close(Assimp::IOStream *file) override { files_.Close(file); }
    bool ComparePaths(const char *one, const char *second) const override {
        return files_.ComparePaths(one, second);
    }

private:
    Assimp::DefaultIOSystem files_;  // not a base: Assimp 6 has it final
    std::filesystem::path file_;
    AssimpFiles &asked_;
};

}  // namespace stagelight
