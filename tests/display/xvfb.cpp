// SPDX-License-Identifier: MIT
#include "display/xvfb.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace stagelight {
namespace {

// Between fork and exec: nothing here may allocate. The server dies with the test.
[[noreturn]] void become_xvfb(const char *number_to, const char *screen) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int nowhere = open("/dev/null", O_RDWR);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execlp("Xvfb", "Xvfb", "-displayfd", number_to, "-screen", "0", screen, "-nolisten", "tcp",
           "-noreset", nullptr);
    _exit(127);
}

// Xvfb writes the number of its display once it takes connections.
std::string read_line(int descriptor) {
    std::string line;
    for (char c = 0; read(descriptor, &c, 1) == 1 && c != '\n';) {
        line += c;
    }
    return line;
}

}  // namespace

Xvfb::Xvfb(int depth) {
    std::array<int, 2> pipe_ends{};
    if (pipe(pipe_ends.data()) != 0) {
        throw std::runtime_error("no pipe for Xvfb");
    }
    const std::string number_to = std::to_string(pipe_ends[1]);
    const std::string screen = fmt::format("1280x1024x{}", depth);
    process_ = fork();
    if (process_ == 0) {
        become_xvfb(number_to.c_str(), screen.c_str());
    }
    close(pipe_ends[1]);
    const std::string number = read_line(pipe_ends[0]);
    close(pipe_ends[0]);
    if (number.empty()) {
        throw std::runtime_error("Xvfb did not start: apt-get install xvfb");
    }
    display_ = ":" + number;
    setenv("DISPLAY", display_.c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
}

Xvfb::~Xvfb() {
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
}

}  // namespace stagelight
