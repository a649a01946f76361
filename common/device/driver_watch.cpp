// SPDX-License-Identifier: MIT
#include "device/driver_watch.h"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

#include "device/kernel_source.h"

namespace stagelight {
namespace {

constexpr const char *restarts_variable = "STAGELIGHT_DRIVER_ENDED";

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

int restarts() {
    const char *count = std::getenv(restarts_variable);
    return count == nullptr ? 0 : std::atoi(count);
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
