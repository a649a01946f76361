// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace stagelight {

// What is wrong with a PLY file, and what was expected: "" for nothing, and for another format.
// Assimp's reader looks for an end of the header that is missing, and for rows that the file is too
// short for, until its time is up.
std::string ply_fault(const std::filesystem::path &file);

}  // namespace stagelight
