// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/DefaultIOSystem.h>

namespace stagelight {

// Files for Assimp, some of whose readers take what a failing disk has given for all there is.
class CheckedFiles : public Assimp::DefaultIOSystem {
public:
    // Sets `has_failed` when a read gives less than the file has.
    explicit CheckedFiles(bool &has_failed) : has_failed_(has_failed) {}

    Assimp::IOStream *Open(const char *file, const char *mode) override;

private:
    bool &has_failed_;
};

}  // namespace stagelight
