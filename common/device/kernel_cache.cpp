// SPDX-License-Identifier: MIT
#include "device/kernel_cache.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "device/kernel_source.h"
#include "scene/errors.h"
#include "scene/progress.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

// How often the program was started again.
constexpr const char *restarts_variable = "STAGELIGHT_DRIVER_ENDED";

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

// What a new start of this program is given, and all of it made before a driver is watched: a
// handler of signals may not allocate.
struct Restart {
    std::vector<std::string> texts;
    std::vector<char *> arguments, environment;

    void add(std::vector<char *> &to, std::string text) {
        to.push_back(texts.emplace_back(std::move(text)).data());
    }
};
Restart restart;
std::atomic<bool> is_watched = false;
std::terminate_handler driverless_terminate = nullptr;  // an exception of ours is no driver's end

int restarts() {
    const char *count = std::getenv(restarts_variable);
    return count == nullptr ? 0 : std::atoi(count);
}

void prepare_restart() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::vector<std::string> words;
    for (std::string word; std::getline(file, word, '\0');) {
        words.push_back(word);
    }
    std::vector<std::string> variables;
    const std::string counter = restarts_variable + std::string("=");
    for (char **variable = environ; *variable != nullptr; ++variable) {
        if (!std::string_view(*variable).starts_with(counter)) {
            variables.emplace_back(*variable);
        }
    }
    variables.push_back(counter + std::to_string(restarts() + 1));
    restart = {};
    restart.texts.reserve(words.size() + variables.size());  // pointers into it stay
    for (std::string &word : words) {
        restart.add(restart.arguments, std::move(word));
    }
    for (std::string &variable : variables) {
        restart.add(restart.environment, std::move(variable));
    }
    restart.arguments.push_back(nullptr);
    restart.environment.push_back(nullptr);
}

// Returns only where it can't.
void start_again() {
    if (is_watched.exchange(false) && !restart.texts.empty()) {
        execve("/proc/self/exe", restart.arguments.data(), restart.environment.data());
    }
}

// The signal is blocked in its handler, and would be in the program that is started there.
void on_signal(int signal) {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, signal);
    sigprocmask(SIG_UNBLOCK, &set, nullptr);
    std::signal(signal, SIG_DFL);
    start_again();
    raise(signal);
}

}  // namespace

void prepare_kernel_cache() {
    static std::once_flag done;
    std::call_once(done, [] {
        const fs::path folder = pocl_folder();
        const int before = restarts();
        unsetenv(restarts_variable);
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
            setenv(restarts_variable, "1", 1);
        } else if (const std::string lack = lack_of(folder); !lack.empty()) {
            use_temporary_folder(
                fmt::format("compiled kernels can't be kept in {}: {}", folder.string(), lack));
        }
    });
}

DriverWatch::DriverWatch(const std::optional<std::filesystem::path> &own_kernels) {
    if (named_kernels(own_kernels)) {
        return;
    }
    prepare_restart();
    static const bool registered = std::atexit(start_again) == 0;
    static const bool terminates = [] {
        driverless_terminate = std::set_terminate([] {
            is_watched = false;
            driverless_terminate();
        });
        return true;
    }();
    for (const int signal : {SIGABRT, SIGSEGV}) {
        std::signal(signal, on_signal);
    }
    is_watched = registered && terminates;
}

DriverWatch::~DriverWatch() {
    is_watched = false;
    for (const int signal : {SIGABRT, SIGSEGV}) {
        std::signal(signal, SIG_DFL);
    }
}

void start_again_if_watched() {
    if (restarts() == 0) {
        start_again();
    }
}

}  // namespace stagelight
