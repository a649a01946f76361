// SPDX-License-Identifier: MIT
#include "scene/sandbox.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "scene/errors.h"

namespace stagelight {
namespace {

// The first byte of what comes back.
enum Outcome : char { done = 'd', user_error = 'u', no_memory = 'm' };

class Pipe {
public:
    Pipe() {
        if (pipe2(ends_.data(), O_CLOEXEC) != 0) {
            throw MachineError(fmt::format("no pipe to read files through: {}; end other programs",
                                           std::generic_category().message(errno)));
        }
    }
    ~Pipe() {
        close(ends_[0]);
        close_writing();
    }
    Pipe(const Pipe &) = delete;
    Pipe &operator=(const Pipe &) = delete;

    void close_writing() {
        if (ends_[1] >= 0) {
            close(ends_[1]);
            ends_[1] = -1;
        }
    }

    bool write(std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t written = ::write(ends_[1], bytes.data(), bytes.size());
            if (written < 0 && errno != EINTR) {
                return false;
            }
            bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
        }
        return true;
    }

    // All that is written until nobody has the other end.
    std::string read() const {
        std::string bytes;
        std::vector<char> block(1 << 16);
        for (ssize_t size = 1; size != 0;) {
            size = ::read(ends_[0], block.data(), block.size());
            if (size < 0 && errno != EINTR) {
                break;
            }
            bytes.append(block.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
        }
        return bytes;
    }

private:
    std::array<int, 2> ends_{-1, -1};
};

void limit(__rlimit_resource resource, rlim_t soft) {
    rlimit limits{};
    getrlimit(resource, &limits);
    limits.rlim_cur = std::min(limits.rlim_max, soft);
    setrlimit(resource, &limits);
}

// Beyond what the process has already, which under AddressSanitizer is most of all there is.
rlim_t address_space() {
    const auto page = static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
    const auto memory = static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES)) * page;
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * page + memory / 2;
}

// Ten times what the slowest text format takes here.
rlim_t seconds_for(std::uintmax_t file_size) {
    return 8 + file_size / 100'000;
}

// A reader that waits uses no time of the CPU; one on a machine with much else to do waits too.
unsigned patience_for(std::uintmax_t file_size) {
    return static_cast<unsigned>(10 * seconds_for(file_size));
}

void limit_this_process(std::uintmax_t file_size) {
    for (const int fatal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGXCPU, SIGALRM}) {
        std::signal(fatal, SIG_DFL);  // drivers and sanitizers have handlers of their own
    }
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);  // where glibc says that its heap is corrupt
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, seconds_for(file_size));
    limit(RLIMIT_AS, address_space());
    alarm(patience_for(file_size));
}

std::string outcome_of(std::uintmax_t file_size, const std::function<std::string()> &work) {
    try {
        limit_this_process(file_size);
        return char(done) + work();
    } catch (const UserError &error) {
        return char(user_error) + std::string(error.what());
    } catch (const std::bad_alloc &) {
        return {char(no_memory)};
    }
}

// No exception may leave, back into a copy of the caller.
[[noreturn]] void be_child(const Pipe &pipe, std::uintmax_t file_size,
                           const std::function<std::string()> &work) noexcept {
    _exit(pipe.write(outcome_of(file_size, work)) ? 0 : 1);
}

int status_of(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

std::string death_by(int signal, std::uintmax_t file_size) {
    switch (signal) {
    case SIGXCPU:
        return fmt::format("takes longer than {} seconds", seconds_for(file_size));
    case SIGALRM:
        return fmt::format("takes longer than {} seconds", patience_for(file_size));
    default:
        return fmt::format("the reader crashed (signal {})", signal);
    }
}

}  // namespace

void allow_any_time() {
    alarm(0);
    limit(RLIMIT_CPU, RLIM_INFINITY);
}

std::string run_sandboxed(const std::string &what, std::uintmax_t file_size,
                          const std::function<std::string()> &work, const std::string &expected) {
    Pipe pipe;
    const pid_t child = fork();
    if (child < 0) {
        throw MachineError(fmt::format("no process to read {} in: {}; end other programs", what,
                                       std::generic_category().message(errno)));
    }
    if (child == 0) {
        be_child(pipe, file_size, work);
    }
    pipe.close_writing();
    std::string bytes = pipe.read();
    const int status = status_of(child);
    if (WIFSIGNALED(status)) {
        throw UserError(fmt::format("{}: can't be read: {}, expected {}", what,
                                    death_by(WTERMSIG(status), file_size), expected));
    }
    if (status != 0 || bytes.empty()) {  // a sanitizer has found a mistake of ours
        throw std::logic_error(fmt::format("reading {} ended with status {}", what, status));
    }
    const char outcome = bytes.front();
    bytes.erase(0, 1);
    if (outcome == no_memory) {
        throw std::bad_alloc();
    }
    if (outcome == user_error) {
        throw UserError(bytes);
    }
    return bytes;
}

}  // namespace stagelight
