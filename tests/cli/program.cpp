// SPDX-License-Identifier: MIT
#include "cli/program.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace stagelight::cli {
namespace {

namespace fs = std::filesystem;

constexpr auto patience = std::chrono::minutes(1);

// What a program writes to it can be read when it has ended.
class Catch {
public:
    Catch() : descriptor_(memfd_create("output", MFD_CLOEXEC)) {}
    ~Catch() { close(descriptor_); }
    Catch(const Catch &) = delete;
    Catch &operator=(const Catch &) = delete;

    int descriptor() const { return descriptor_; }

    std::string text() const {
        std::string text(static_cast<std::size_t>(lseek(descriptor_, 0, SEEK_END)), '\0');
        const ssize_t size = pread(descriptor_, text.data(), text.size(), 0);
        text.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
        return text;
    }

private:
    int descriptor_;
};

// Kernels are built once for all tests, beside the programs that they belong to.
std::string kernel_cache() {
    if (const char *chosen = std::getenv("POCL_CACHE_DIR")) {
        return chosen;
    }
    const fs::path cache = fs::path(STAGELIGHT_BINARY_DIR) / "tests" / "pocl_cache";
    fs::create_directories(cache);
    return cache;
}

std::vector<std::string> environment_of(const Start &start) {
    constexpr std::array<std::string_view, 6> ours{
        "STAGELIGHT_",    "RUSTICL_ENABLE=", "OCL_ICD_VENDORS=",
        "OPENCL_LAYERS=", "DISPLAY=",        "WAYLAND_DISPLAY="};
    std::vector<std::string> environment = start.environment;
    for (char **variable = environ; *variable != nullptr; ++variable) {
        const std::string_view inherited = *variable;
        if (std::ranges::none_of(ours, [&](auto name) { return inherited.starts_with(name); })) {
            environment.emplace_back(inherited);
        }
    }
    environment.push_back("POCL_CACHE_DIR=" + kernel_cache());
    return environment;
}

// Without what rusticl says while it builds a kernel that its cache has not yet, and the count that
// newer versions of PoCL leave of Clang's warnings: no concern of the program's.
std::string without_drivers_words(const std::string &text) {
    std::istringstream lines(text);
    std::string rest;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("MESA: warning: Treating load_kernel_arg")
            && !line.ends_with(" warnings generated.") && !line.ends_with(" warning generated.")) {
            rest += line + '\n';
        }
    }
    return rest;
}

std::vector<char *> pointers(std::vector<std::string> &texts) {
    std::vector<char *> result;
    for (std::string &text : texts) {
        result.push_back(text.data());
    }
    result.push_back(nullptr);
    return result;
}

// Between fork and exec: nothing here may allocate.
[[noreturn]] void become(char **arguments, char **environment, const char *folder,
                         const Start &start, const Catch &out, const Catch &err) {
    const rlimit largest{start.largest_file, start.largest_file};
    std::signal(SIGXFSZ, SIG_IGN);  // a write past the limit is to fail, as on a full disk
    if (chdir(folder) == 0 && dup2(out.descriptor(), STDOUT_FILENO) >= 0
        && dup2(err.descriptor(), STDERR_FILENO) >= 0 && setrlimit(RLIMIT_FSIZE, &largest) == 0) {
        execve(arguments[0], arguments, environment);
    }
    _exit(127);
}

int wait_for(pid_t child) {
    const auto end = std::chrono::steady_clock::now() + patience;
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > end) {
            kill(child, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

Outcome Cli::run(const std::string &stage, const Start &start) const {
    std::vector<std::string> words = start.arguments;
    words.insert(words.begin(), std::string(STAGELIGHT_BINARY_DIR) + "/stages/" + stage);
    std::vector<std::string> variables = environment_of(start);
    std::vector<char *> arguments = pointers(words);
    std::vector<char *> environment = pointers(variables);
    const Catch out;
    const Catch err;
    const pid_t child = fork();
    if (child < 0) {
        throw std::runtime_error("fork failed");
    }
    if (child == 0) {
        become(arguments.data(), environment.data(), folder.path().c_str(), start, out, err);
    }
    const int code = wait_for(child);
    return {code, out.text(), without_drivers_words(err.text())};
}

std::vector<std::string> Cli::files() const {
    std::vector<std::string> names;
    for (const auto &entry : fs::recursive_directory_iterator(folder.path())) {
        names.push_back(entry.path().lexically_relative(folder.path()));
    }
    std::ranges::sort(names);
    return names;
}

std::ostream &operator<<(std::ostream &stream, const Outcome &outcome) {
    return stream << "exit code " << outcome.code << "\nstdout: " << outcome.out
                  << "\nstderr: " << outcome.err;
}

void expect_done(const Outcome &outcome) {
    EXPECT_TRUE(outcome.code == 0 && outcome.err.empty())
        << "expected exit code 0 and nothing on stderr\n"
        << outcome;
}

void expect_one_line(const Outcome &outcome, int code, const std::string &text) {
    EXPECT_EQ(outcome.code, code) << outcome;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("error: ")
                && outcome.err.find('\n') + 1 == outcome.err.size())
        << "expected one line that begins with 'error: '\n"
        << outcome;
    expect_part(outcome.err, text);
}

void expect_part(const std::string &text, const std::string &part) {
    EXPECT_NE(text.find(part), std::string::npos) << "expected: " << part << "\nin: " << text;
}

}  // namespace stagelight::cli
