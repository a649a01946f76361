// SPDX-License-Identifier: MIT
// Where meshes and pictures are looked for: beside the scene file, then in the
// folders of STAGELIGHT_ASSETS (separated by ':'), then where Debian's
// assimp-testmodels and glmark2-data put them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace stagelight {

// A Debian package of assets.
struct AssetPackage {
    std::string name;
    std::filesystem::path folder;  // where it puts them
    std::vector<std::string>
        files;  // those that this project uses: known even before it is installed
};

const std::vector<AssetPackage> &debian_packages();

// The first existing regular file that `name` stands for; an absolute name is
// taken as it is. Packages are searched by file name too, below their sub-folders;
// of several the first by path. Throws UserError (scene/errors.h) at `where`: it
// names the folders that were searched, and the package that has the file if one is
// known to.
std::filesystem::path find_asset(const std::string &name, const std::filesystem::path &scene_folder,
                                 const SourceLocation &where,
                                 const std::vector<AssetPackage> &packages = debian_packages());

}  // namespace stagelight
