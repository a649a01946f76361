// SPDX-License-Identifier: MIT
// ./stagelight bench peers: the full tracer beside Embree and POV-Ray, on the same cameras, in the
// same run.
#include <map>
#include <thread>

#include <fmt/format.h>

#include "app/run_main.h"
#include "bench/generated_scenes.h"
#include "bench/peers/embree_race.h"
#include "bench/peers/povray_race.h"
#include "device/device_choice.h"
#include "scene/errors.h"
#include "scene/scene_file.h"

namespace stagelight::bench {
namespace {

// The cores that OpenCL has, where it runs on the processor.
int threads_beside(const cl::Device &device) {
    return device.getInfo<CL_DEVICE_TYPE>() == CL_DEVICE_TYPE_CPU
               ? static_cast<int>(device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>())
               : static_cast<int>(std::thread::hardware_concurrency());
}

Scene model(const std::string &name) {
    return load_scene(std::filesystem::path(STAGELIGHT_SOURCE_DIR) / "tests/bench/peers"
                      / (name + ".toml"));
}

int peers(int argc) {
    if (argc > 1) {
        throw UserError("bench peers takes no options; STAGELIGHT_DEVICE chooses the device");
    }
    const std::filesystem::path file = report_file("bench_peers.json");
    const cl::Device device = choose_device("");
    fmt::print("{}\n", device.getInfo<CL_DEVICE_NAME>());
    ordered_json report = {{"device", device_json(device)}};
    const int threads = threads_beside(device);
    Workers workers(threads);
    const std::map<std::string, Scene> scenes{{"bunny", model("bunny")},
                                              {"horse", model("horse")},
                                              {"ring, coarse", ring(16)},
                                              {"ring, fine", ring(512)}};
    for (const auto &[name, scene] : scenes) {
        if (!race_embree(device, name, scene, workers, report)) {
            return exit_check_failed;
        }
    }
    if (!race_povray(device, threads, report)) {
        return exit_check_failed;
    }
    write_report(report, file);
    return exit_done;
}

}  // namespace
}  // namespace stagelight::bench

int main(int argc, char **) {
    return stagelight::run_main([&] { return stagelight::bench::peers(argc); });
}
