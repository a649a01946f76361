// SPDX-License-Identifier: MIT
#include "device/kernel_cache.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "device/driver_watch.h"
#include "scene/errors.h"
#include "scene/progress.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

// Where PoCL looks for its folder (PoCL's manual, "Environment variables").
fs::path pocl_folder() {
    if (const char *folder = std::getenv("POCL_CACHE_DIR")) {
        return folder;
    }
    if (const char *caches = std::getenv("XDG_CACHE_HOME")) {
        return fs::path(caches) / "pocl" / "kcache";
    }
    const char *home = std::getenv("HOME");
    return home == nullptr ? "/tmp/pocl/kcache" : fs::path(home) / ".cache" / "pocl" / "kcache";
}

// Why the folder can't hold kernels, or "". Makes it.
std::string lack_of(const fs::path &folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        return error.message();
    }
    std::string probe = (folder / ".stagelight-XXXXXX").string();
    const int file = mkstemp(probe.data());
    if (file < 0) {
        return std::generic_category().message(errno);
    }
    close(file);
    fs::remove(probe, error);
    constexpr std::uintmax_t enough = 16U
                                      << 20U;  // ten times what the largest stage's kernel takes
    struct statvfs disk {};
    if (statvfs(folder.c_str(), &disk) == 0 && disk.f_bavail * disk.f_frsize < enough) {
        return std::generic_category().message(ENOSPC);
    }
    return "";
}

constexpr const char *temporary_name = "stagelight-kernels-";
fs::path temporary_folder;

// After the drivers have ended: what was registered first is called last.
void remove_temporary_folder() {
    std::error_code ignored;
    fs::remove_all(temporary_folder, ignored);
}

void use_temporary_folder(const std::string &why) {
    std::error_code error;
    std::string name =
        (fs::temp_directory_path(error) / (temporary_name + std::string("XXXXXX"))).string();
    if (error || mkdtemp(name.data()) == nullptr) {
        throw MachineError(why + "; POCL_CACHE_DIR can name another folder");
    }
    temporary_folder = name;
    setenv("POCL_CACHE_DIR", name.c_str(), 1);
    std::atexit(remove_temporary_folder);
    warn(why + "; they go to a temporary folder, unless POCL_CACHE_DIR names another");
}

}  // namespace

void prepare_kernel_cache() {
    static std::once_flag done;
    std::call_once(done, [] {
        const fs::path folder = pocl_folder();
        const int before = restarts();
        if (before > 1) {
            if (folder.filename().string().starts_with(temporary_name)) {
                temporary_folder = folder;
                std::atexit(remove_temporary_folder);
            }
            throw MachineError("the OpenCL driver ended the program, see above for its own words; "
                               "try another --device (--list-devices)");
        }
        if (before == 1) {
            use_temporary_folder(fmt::format("the OpenCL driver ended the program: compiled "
                                             "kernels in {} may be damaged (remove it)",
                                             folder.string()));
        } else if (const std::string lack = lack_of(folder); !lack.empty()) {
            use_temporary_folder(
                fmt::format("compiled kernels can't be kept in {}: {}", folder.string(), lack));
        }
    });
}

}  // namespace stagelight
