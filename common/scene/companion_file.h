// SPDX-License-Identifier: MIT
// The files that a mesh file names: its pictures, its materials. What it calls them is often of
// another machine, whose folders are others and whose letter case does not count.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stagelight {

// The file `name` in `folder`, also with its %20 decoded, and in any letter case.
std::optional<std::filesystem::path> find_spelled(const std::string &name,
                                                  const std::filesystem::path &folder);

// The file that is most like `name`: by as many of its last parts as can be found in one of
// `folders`, in textures/ there, in ../textures, or, with the folder that it is in, next to the
// folder; else the first of that file name below the first folder, at most three folders down. What
// is absolute and there is taken as it is.
std::optional<std::filesystem::path>
find_companion(const std::string &name, const std::vector<std::filesystem::path> &folders);

}  // namespace stagelight
