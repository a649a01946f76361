// SPDX-License-Identifier: MIT
// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <span>

namespace stagelight {

// Throws UserError unless the folder of `file` exists and takes new files, and `file` itself
// is a regular file or nothing yet. It tries with an empty file, since permission bits say
// nothing to root and nothing about a read-only disk.
void require_writable_place(const std::filesystem::path &file);

// Writes a new file beside `file` and renames it to that: a failure (a full disk) leaves no
// half file, and an old one as it was. Throws UserError with the system's reason.
void write_whole(std::span<const unsigned char> bytes, const std::filesystem::path &file);

}  // namespace stagelight
