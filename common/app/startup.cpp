// SPDX-License-Identifier: MIT
#include "app/startup.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>

#include <unistd.h>

namespace stagelight {
namespace {

// How long this process has been there, milliseconds, to the kernel's tick of mostly 10: the loader
// has linked hundreds of libraries before main. 0 where the kernel does not tell (proc(5), field 22
// of stat; the second, in brackets, may hold spaces).
double process_age() {
    std::ifstream file("/proc/self/stat");
    const std::string stat{std::istreambuf_iterator<char>(file), {}};
    std::istringstream fields(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));
    std::string skipped;
    for (int field = 3; field < 22; ++field) {
        fields >> skipped;
    }
    double ticks = 0;
    timespec since_boot{};
    if (!(fields >> ticks) || clock_gettime(CLOCK_BOOTTIME, &since_boot) != 0) {
        return 0;
    }
    const double now = 1e3 * double(since_boot.tv_sec) + 1e-6 * double(since_boot.tv_nsec);
    return std::max(0.0, now - 1e3 * ticks / double(sysconf(_SC_CLK_TCK)));
}

}  // namespace

Startup::Startup() : part_began_(now_milliseconds() - process_age()) {}

void Startup::done(const std::string &part, double until) {
    add(part, until - part_began_);
    part_began_ = until;
}

void Startup::built(const StageKernel &kernel) {
    const auto &[tree, build, upload] = kernel.milliseconds();
    part_began_ += tree + build + upload;
    done("device");
    add("tree", tree);
    add("kernel", build);
    add("upload", upload);
}

void Startup::add(const std::string &part, double milliseconds) {
    const auto known = std::ranges::find(parts_, part, [](const auto &it) { return it.first; });
    if (known == parts_.end()) {
        parts_.emplace_back(part, milliseconds);
    } else {
        known->second += milliseconds;
    }
}

double Startup::total() const {
    double total = 0;
    for (const auto &[part, milliseconds] : parts_) {
        total += milliseconds;
    }
    return total;
}

}  // namespace stagelight
