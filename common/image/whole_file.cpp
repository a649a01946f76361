// SPDX-License-Identifier: MIT
#include "image/whole_file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "scene/errors.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path &file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

// A name no other thread or running process uses.
fs::path temporary_name(const fs::path &folder) {
    static std::atomic<int> count = 0;
    return folder / fmt::format(".stagelight-{}-{}.tmp", getpid(), ++count);
}

// A new file in a folder, gone again unless it was given a name to keep.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path &folder) : name_(temporary_name(folder)) {
        unlink(name_.c_str());  // what a killed process of the same number left
        descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        check(descriptor_ >= 0);
    }
    ~TemporaryFile() {
        if (descriptor_ >= 0) {
            close(descriptor_);
        }
        unlink(name_.c_str());
    }
    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    void write(std::span<const unsigned char> bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            check(written > 0 || errno == EINTR);
            bytes = bytes.subspan(std::size_t(std::max<ssize_t>(written, 0)));
        }
    }

    // Some file systems find out only when they flush or close that there is no room.
    void keep_as(const fs::path &file) {
        check(fsync(descriptor_) == 0);
        check(close(std::exchange(descriptor_, -1)) == 0);
        check(rename(name_.c_str(), file.c_str()) == 0);
    }

private:
    static void check(bool done) {
        if (!done) {
            throw std::system_error(errno, std::generic_category());
        }
    }

    fs::path name_;
    int descriptor_ = -1;
};

void require_file_or_nothing(const fs::path &file) {
    std::error_code error;
    const fs::file_type type = fs::symlink_status(file, error).type();
    if (type == fs::file_type::none) {
        throw UserError(fmt::format("{}: {}", file.string(), error.message()));
    }
    if (type != fs::file_type::regular && type != fs::file_type::not_found) {
        throw UserError(fmt::format("{}: expected a regular file or a new name, found a {}",
                                    file.string(),
                                    type == fs::file_type::directory ? "folder"
                                    : type == fs::file_type::symlink ? "symbolic link"
                                                                     : "special file"));
    }
}

}  // namespace

void require_writable_place(const fs::path &file) {
    const fs::path folder = folder_of(file);
    try {
        if (!fs::is_directory(folder)) {
            throw UserError(fmt::format("{}: {} {}; expected a folder that exists", file.string(),
                                        folder.string(),
                                        fs::exists(folder) ? "is not a folder" : "does not exist"));
        }
        require_file_or_nothing(file);
        const TemporaryFile probe(folder);
    } catch (const std::system_error &error) {
        throw UserError(fmt::format("{}: the folder {} cannot be written to: {}", file.string(),
                                    folder.string(), error.code().message()));
    }
}

void write_whole(std::span<const unsigned char> bytes, const fs::path &file) {
    require_file_or_nothing(file);
    try {
        TemporaryFile temporary(folder_of(file));
        temporary.write(bytes);
        temporary.keep_as(file);
    } catch (const std::system_error &error) {
        throw UserError(
            fmt::format("{}: cannot be written: {}", file.string(), error.code().message()));
    }
}

}  // namespace stagelight
