// SPDX-License-Identifier: MIT
// ./stagelight bench peers: the full tracer beside Embree and POV-Ray, on the same cameras, in the
// same run.
#include <thread>

#include <fmt/format.h>

#include "app/run_main.h"
#include "bench/peers/embree_race.h"
#include "bench/peers/povray_race.h"
#include "device/device_choice.h"
#include "scene/errors.h"

namespace stagelight::bench {
namespace {

// The cores that OpenCL has, where it runs on the processor.
int threads_beside(const cl::Device &device) {
    return device.getInfo<CL_DEVICE_TYPE>() == CL_DEVICE_TYPE_CPU
               ? static_cast<int>(device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>())
               : static_cast<int>(std::thread::hardware_concurrency());
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
    const bool all_right = race_embree(device, "bunny", workers, report)
                           && race_embree(device, "horse", workers, report)
                           && race_povray(device, threads, report);
    if (!all_right) {
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
