// SPDX-License-Identifier: MIT
#include "device/device_choice.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>

#include <sched.h>
#include <unistd.h>

#include <fmt/format.h>

#include "scene/errors.h"

namespace stagelight {
namespace {

constexpr auto no_device_remedy =
    "no OpenCL device: install a driver (Debian: apt-get install pocl-opencl-icd)";

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

bool is_index(const std::string &spec) {
    return !spec.empty() && spec.size() < 6
           && std::ranges::all_of(spec, [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::optional<cl::Device> first_of_type(const std::vector<cl::Device> &devices,
                                        cl_device_type type) {
    const auto found = std::ranges::find_if(devices, [type](const cl::Device &device) {
        return (device.getInfo<CL_DEVICE_TYPE>() & type) != 0;
    });
    return found == devices.end() ? std::nullopt : std::optional(*found);
}

std::optional<cl::Device> find_device(const std::vector<cl::Device> &devices,
                                      const std::string &spec) {
    if (is_index(spec)) {
        const std::size_t index = std::stoul(spec);
        return index < devices.size() ? std::optional(devices[index]) : std::nullopt;
    }
    if (lower(spec) == "cpu") {
        return first_of_type(devices, CL_DEVICE_TYPE_CPU);
    }
    if (lower(spec) == "gpu") {
        return first_of_type(devices, CL_DEVICE_TYPE_GPU);
    }
    const auto found = std::ranges::find_if(devices, [&spec](const cl::Device &device) {
        return lower(device.getInfo<CL_DEVICE_NAME>()).find(lower(spec)) != std::string::npos;
    });
    return found == devices.end() ? std::nullopt : std::optional(*found);
}

// A platform may have none, and says so by an error.
std::vector<cl::Device> devices_of(const cl::Platform &platform) {
    std::vector<cl::Device> devices;
    try {
        platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    } catch (const cl::Error &error) {
        if (error.err() != CL_DEVICE_NOT_FOUND) {
            throw;
        }
    }
    return devices;
}

// PoCL's threads, each on a core of its own: otherwise the scheduler now and then wakes two on one
// core, and a short frame takes twice as long. Not where we are kept to some cores: PoCL would use
// others too.
void keep_threads_apart() {
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0
        && CPU_COUNT(&allowed) == sysconf(_SC_NPROCESSORS_ONLN)) {
        setenv("POCL_AFFINITY", "1", 0);
    }
}

}  // namespace

std::vector<cl::Device> all_devices() {
    keep_threads_apart();
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error &error) {
        constexpr int platform_not_found_khr = -1001;  // the loader's word for no driver at all
        if (error.err() != platform_not_found_khr) {
            throw;
        }
    }
    std::vector<cl::Device> devices;
    for (const cl::Platform &platform : platforms) {
        const std::vector<cl::Device> found = devices_of(platform);
        devices.insert(devices.end(), found.begin(), found.end());
    }
    return devices;
}

bool has_extension(const cl::Device &device, const char *extension) {
    const std::string all = ' ' + device.getInfo<CL_DEVICE_EXTENSIONS>() + ' ';
    return all.find(' ' + std::string(extension) + ' ') != std::string::npos;
}

std::string list_devices() {
    const std::vector<cl::Device> devices = all_devices();
    if (devices.empty()) {
        return std::string(no_device_remedy) + '\n';
    }
    std::string list;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const cl::Platform platform(devices[i].getInfo<CL_DEVICE_PLATFORM>());
        list += fmt::format("{}: {} ({}, {})\n", i, devices[i].getInfo<CL_DEVICE_NAME>(),
                            platform.getInfo<CL_PLATFORM_NAME>(),
                            devices[i].getInfo<CL_DEVICE_VERSION>());
    }
    return list;
}

std::string named_device(const std::string &spec) {
    const char *from_environment = std::getenv("STAGELIGHT_DEVICE");
    return spec.empty() && from_environment != nullptr ? from_environment : spec;
}

cl::Device choose_device(const std::string &spec) {
    const std::vector<cl::Device> devices = all_devices();
    if (devices.empty()) {
        throw MachineError(no_device_remedy);
    }
    const std::string wanted = named_device(spec);
    if (wanted.empty()) {
        return first_of_type(devices, CL_DEVICE_TYPE_GPU).value_or(devices.front());
    }
    const std::optional<cl::Device> device = find_device(devices, wanted);
    if (!device) {
        throw MachineError(
            fmt::format("no OpenCL device '{}'; there are:\n{}", wanted, list_devices()));
    }
    return *device;
}

}  // namespace stagelight
