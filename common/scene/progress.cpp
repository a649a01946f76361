// SPDX-License-Identifier: MIT
#include "scene/progress.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <utility>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace stagelight {
namespace {

constexpr std::chrono::seconds patience(2);
constexpr std::chrono::milliseconds period(250);
constexpr std::size_t bar_length = 24;
constexpr std::size_t most_lines = 5;           // of warnings
constexpr const char *clear_line = "\r\x1b[K";  // ECMA-48: carriage return, erase to the end

std::atomic<bool> one_is_drawn = false;
std::mutex terminal;      // who writes to it, and all below
bool is_visible = false;  // a bar, since the last line
std::vector<std::string> warnings;
bool are_warnings_silenced = false;

void clear() {
    if (std::exchange(is_visible, false)) {
        fmt::print(stderr, "{}", clear_line);
    }
}

// A longer line would wrap, and only its last part be cleared.
std::size_t terminal_width() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col - 1U : 79U;
}

}  // namespace

Progress::Progress(std::string what, std::size_t steps)
    : what_(std::move(what)), steps_(steps),
      is_drawn_(isatty(STDERR_FILENO) != 0 && !one_is_drawn.exchange(true)) {
    if (is_drawn_) {  // a thread, since what takes long does not look up from it
        drawing_ = std::jthread([this](const std::stop_token &stop) { keep_drawing(stop); });
    }
}

Progress::~Progress() {
    if (is_drawn_) {
        drawing_.request_stop();
        drawing_.join();
        one_is_drawn = false;
    }
}

void say(const std::string &line) {
    const std::lock_guard lock(terminal);
    clear();
    fmt::print("{}\n", line);
    std::fflush(stdout);
}

void warn(const std::string &line) {
    warn(std::vector{line});
}

void warn(const std::vector<std::string> &lines) {
    const std::lock_guard lock(terminal);
    warnings.insert(warnings.end(), lines.begin(), lines.end());
    if (are_warnings_silenced) {
        return;
    }
    clear();
    const std::size_t shown = lines.size() > most_lines ? most_lines - 1 : lines.size();
    for (std::size_t i = 0; i < shown; ++i) {
        fmt::print(stderr, "warning: {}\n", lines[i]);
    }
    if (shown < lines.size()) {
        fmt::print(stderr, "warning: {} more; --stats FILE has all of them\n",
                   lines.size() - shown);
    }
}

void silence_warnings() {
    const std::lock_guard lock(terminal);
    are_warnings_silenced = true;
}

std::vector<std::string> all_warnings() {
    const std::lock_guard lock(terminal);
    return warnings;
}

void Progress::keep_drawing(const std::stop_token &stop) {
    const auto never = [] { return false; };
    std::unique_lock lock(terminal);
    wake_.wait_for(lock, stop, patience, never);
    while (!stop.stop_requested()) {
        is_visible = true;
        fmt::print(stderr, "{}{}", clear_line, text().substr(0, terminal_width()));
        wake_.wait_for(lock, stop, period, never);
    }
    clear();
}

std::string Progress::text() const {
    const double seconds = (now_milliseconds() - start_) / 1000;
    if (steps_ <= 1) {
        return fmt::format("{}, {:.0f} s", what_, seconds);
    }
    const std::size_t done = std::min<std::size_t>(done_, steps_);
    const std::string bar(bar_length * done / steps_, '#');
    return fmt::format("{} [{:-<{}}] {} of {}, {:.0f} s", what_, bar, bar_length, done, steps_,
                       seconds);
}

}  // namespace stagelight
