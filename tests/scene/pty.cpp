// SPDX-License-Identifier: MIT
#include "scene/pty.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

namespace stagelight {

AtTerminal::AtTerminal(const std::function<void()> &body) {
    child_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
    if (child_ < 0) {
        throw std::runtime_error("forkpty failed");
    }
    if (child_ == 0) {
        termios settings{};
        tcgetattr(STDIN_FILENO, &settings);
        settings.c_lflag &= ~tcflag_t(ECHO);
        tcsetattr(STDIN_FILENO, TCSANOW, &settings);
        body();
        std::fflush(nullptr);
        _exit(0);
    }
}

AtTerminal::~AtTerminal() {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
    close(terminal_);
}

void AtTerminal::wait_for(const std::string &part) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    std::array<char, 4096> buffer{};
    while (output_.find(part) == std::string::npos && std::chrono::steady_clock::now() < end) {
        pollfd asked{terminal_, POLLIN, 0};
        if (poll(&asked, 1, 100) > 0) {
            const ssize_t size = read(terminal_, buffer.data(), buffer.size());
            if (size <= 0) {
                return;  // the child has ended
            }
            output_.append(buffer.data(), std::size_t(size));
        }
    }
}

void AtTerminal::enter() const {
    if (write(terminal_, "\n", 1) != 1) {
        throw std::runtime_error("the terminal takes no input");
    }
}

}  // namespace stagelight
