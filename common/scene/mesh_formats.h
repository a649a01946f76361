// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace stagelight {

// What a message says was expected instead of a file of a format that Assimp has no reader for, or
// one that fails on good files: the cause, and a way out. Nothing for other formats.
std::optional<std::string> expected_instead_of(const std::filesystem::path &file);

}  // namespace stagelight
