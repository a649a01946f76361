// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/DefaultIOSystem.h>

namespace stagelight {

// Files for Assimp, some of whose readers take what a failing disk has given for all there is.
class CheckedIOSystem : public Assimp::IOSystem {
public:
    // Sets `has_failed` when a read gives less than the file has.
    explicit CheckedIOSystem(bool &has_failed) : has_failed_(has_failed) {}

    bool Exists(const char *file) const override { return files_.Exists(file); }
    char getOsSeparator() const override { return files_.getOsSeparator(); }
    Assimp::IOStream *Open(const char *file, const char *mode) override;
    void Close(Assimp::IOStream *file) override { files_.Close(file); }
    bool ComparePaths(const char *one, const char *second) const override {
        return files_.ComparePaths(one, second);
    }

private:
    Assimp::DefaultIOSystem files_;  // not a base: Assimp 6 has it final
    bool &has_failed_;
};

}  // namespace stagelight
