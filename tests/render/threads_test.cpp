// SPDX-License-Identifier: MIT
// PoCL's threads, after a frame.
#include <filesystem>
#include <fstream>
#include <set>

#include <sched.h>
#include <unistd.h>

#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

// The cores that some thread of this process is kept to, alone.
std::set<std::string> cores_of_kept_threads() {
    std::set<std::string> cores;
    for (const auto &task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::ifstream status(task.path() / "status");
        for (std::string line; std::getline(status, line);) {
            const std::string name = "Cpus_allowed_list:\t";
            if (line.starts_with(name) && line.find_first_of(",-") == std::string::npos) {
                cores.insert(line.substr(name.size()));
            }
        }
    }
    return cores;
}

TEST(RenderStage01Threads, StayEachOnACoreOfItsOwn) {
    const cl::Device device = choose_device(implementations.front());
    const cl::Platform platform = platform_of(device);
    if (platform.getInfo<CL_PLATFORM_NAME>() != "Portable Computing Language") {
        GTEST_SKIP() << "not PoCL";
    }
    cpu_set_t allowed;
    ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
    if (CPU_COUNT(&allowed) != sysconf(_SC_NPROCESSORS_ONLN)) {
        GTEST_SKIP() << "kept to some cores, which PoCL would not respect";
    }
    const Scene scene = one_pixel({0, 0, 2}, {0, 0, 0});
    Renderer(device, "01_primitives", scene, settings_of(scene)).render();
    EXPECT_EQ(cores_of_kept_threads().size(), device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>());
}

}  // namespace
}  // namespace stagelight::render
