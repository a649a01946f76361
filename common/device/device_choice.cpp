// SPDX-License-Identifier: MIT
#include "device/device_choice.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>

#include <sched.h>
#include <unistd.h>

#include <fmt/format.h>

#include "device/kernel_cache.h"
#include "scene/errors.h"
#include "scene/progress.h"

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

std::string name_of(const cl::Device &device) {
    return device.getInfo<CL_DEVICE_NAME>();
}

// "NAME (PLATFORM, VERSION)"
std::string description_of(const cl::Device &device) {
    return fmt::format("{} ({}, {})", name_of(device),
                       platform_of(device).getInfo<CL_PLATFORM_NAME>(),
                       device.getInfo<CL_DEVICE_VERSION>());
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
        return lower(description_of(device)).find(lower(spec)) != std::string::npos;
    });
    return found == devices.end() ? std::nullopt : std::optional(*found);
}

// Major and minor, of "OpenCL 1.2 …" or "OpenCL C 1.2 …".
std::pair<int, int> version_in(const std::string &text) {
    std::pair<int, int> version;
    const std::size_t digit = text.find_first_of("0123456789");
    if (digit == std::string::npos
        || std::sscanf(text.c_str() + digit, "%d.%d", &version.first, &version.second) != 2) {
        return {};
    }
    return version;
}

// Why kernels can't run on the device, or "". Some devices are newer than their compiler.
std::string lack_of(const cl::Device &device, bool needs_images) {
    for (const std::string &version :
         {device.getInfo<CL_DEVICE_VERSION>(), device.getInfo<CL_DEVICE_OPENCL_C_VERSION>()}) {
        if (version_in(version) < std::pair(1, 2)) {
            return fmt::format("has {}, expected 1.2 or newer", version);
        }
    }
    if (needs_images && device.getInfo<CL_DEVICE_IMAGE_SUPPORT>() == CL_FALSE) {
        return "has no images, which textures need";
    }
    return "";
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
// core, and a short frame takes twice as long. Not where we are kept to some cores, since PoCL
// would use others too, nor where somebody says how many threads there are: PoCL aborts when a
// thread finds no core.
void pin_threads() {
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0
        && CPU_COUNT(&allowed) == sysconf(_SC_NPROCESSORS_ONLN)
        && std::getenv("POCL_MAX_PTHREAD_COUNT") == nullptr
        && std::getenv("POCL_CPU_MAX_CU_COUNT") == nullptr) {
        setenv("POCL_AFFINITY", "1", 0);
    }
}

}  // namespace

std::vector<cl::Device> all_devices() {
    prepare_kernel_cache();
    pin_threads();
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

bool is_gpu(const cl::Device &device) {
    return (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_GPU) != 0;
}

std::string list_devices() {
    const std::vector<cl::Device> devices = all_devices();
    if (devices.empty()) {
        return std::string(no_device_remedy) + '\n';
    }
    std::string list;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        list += fmt::format("{}: {}\n", i, description_of(devices[i]));
    }
    return list;
}

std::string named_device(const std::string &spec) {
    const char *from_environment = std::getenv("STAGELIGHT_DEVICE");
    return spec.empty() && from_environment != nullptr ? from_environment : spec;
}

std::vector<cl::Device> devices_to_try(const std::string &spec, bool needs_images) {
    std::vector<cl::Device> devices = all_devices();
    if (devices.empty()) {
        throw MachineError(no_device_remedy);
    }
    const std::string wanted = named_device(spec);
    if (!wanted.empty()) {
        const std::optional<cl::Device> device = find_device(devices, wanted);
        if (!device) {
            throw MachineError(
                fmt::format("no OpenCL device '{}'; there are:\n{}", wanted, list_devices()));
        }
        if (const std::string lack = lack_of(*device, needs_images); !lack.empty()) {
            throw MachineError(fmt::format("{} {}; choose another --device (--list-devices)",
                                           name_of(*device), lack));
        }
        return {*device};
    }
    std::erase_if(devices, [needs_images](const cl::Device &device) {
        const std::string lack = lack_of(device, needs_images);
        if (!lack.empty()) {
            warn(fmt::format("{} {}: passed over", name_of(device), lack));
        }
        return !lack.empty();
    });
    if (devices.empty()) {
        throw MachineError(no_device_remedy);
    }
    std::stable_partition(devices.begin(), devices.end(), is_gpu);
    return devices;
}

cl::Device choose_device(const std::string &spec) {
    return devices_to_try(spec).front();
}

cl::Device first_that_builds(const std::vector<cl::Device> &devices,
                             const std::function<void(const cl::Device &)> &build) {
    for (auto device = devices.begin(); device + 1 != devices.end(); ++device) {
        const auto give_way = [&](const std::string &reason) {
            warn(fmt::format("{}: {}; trying {}", name_of(*device), reason, name_of(device[1])));
        };
        try {
            build(*device);
            return *device;
        } catch (const DeviceError &error) {
            give_way(error.reason());
        } catch (const cl::Error &error) {
            give_way(fmt::format("{} failed with error {}", error.what(), error.err()));
        }
    }
    build(devices.back());
    return devices.back();
}

}  // namespace stagelight
