// SPDX-License-Identifier: MIT
// What devices and platforms say of themselves.
#include <cstring>
#include <string>
#include <vector>

#include "driver.h"
#include "layer.h"
#include "refusal.h"

namespace stagelight {
namespace {

// Nobody shall take its timings for those of memory that is truly shared.
constexpr char name_suffix[] = " (GL sharing by copying)";

std::vector<std::string> offered_extensions() {
    std::vector<std::string> names{"cl_khr_gl_sharing"};
    if (offers_gl_event()) {
        names.emplace_back("cl_khr_gl_event");
    }
    return names;
}

// What a query of the driver gives, as bytes.
template <typename Ask> std::string bytes_of(Ask ask) {
    std::size_t size = 0;
    require(ask(0, nullptr, &size));
    std::string bytes(size, '\0');
    require(ask(size, bytes.data(), nullptr));
    return bytes;
}

std::string with_extensions(const std::string &bytes) {
    std::string text = bytes.c_str();
    for (const std::string &name : offered_extensions()) {
        if (!names_extension(text, name)) {
            text += (text.empty() || text.back() == ' ' ? "" : " ") + name;
        }
    }
    return text + '\0';
}

std::string with_versioned_extensions(std::string bytes) {
    for (const std::string &name : offered_extensions()) {
        cl_name_version entry{};
        entry.version = CL_MAKE_VERSION(1, 0, 0);
        std::strncpy(entry.name, name.c_str(), sizeof(entry.name) - 1);
        if (bytes.find(name + '\0') == std::string::npos) {
            bytes.append(reinterpret_cast<const char *>(&entry), sizeof(entry));
        }
    }
    return bytes;
}

std::string changed(cl_device_info name, const std::string &bytes) {
    switch (name) {
    case CL_DEVICE_NAME:
        return std::string(bytes.c_str()) + name_suffix + '\0';
    case CL_DEVICE_EXTENSIONS:
    case CL_PLATFORM_EXTENSIONS:
        return with_extensions(bytes);
    default:
        return with_versioned_extensions(bytes);
    }
}

cl_int CL_API_CALL get_device_info(cl_device_id device, cl_device_info name, std::size_t size,
                                   void *value, std::size_t *size_ret) {
    const auto ask = [=](std::size_t room, void *to, std::size_t *size_to) {
        return driver->clGetDeviceInfo(device, name, room, to, size_to);
    };
    if (name != CL_DEVICE_NAME && name != CL_DEVICE_EXTENSIONS
        && name != CL_DEVICE_EXTENSIONS_WITH_VERSION) {
        return ask(size, value, size_ret);
    }
    return answer([&] {
        if (!is_served(device)) {
            return require(ask(size, value, size_ret));
        }
        const std::string result = changed(name, bytes_of(ask));
        Query{size, value, size_ret}.give(result.data(), result.size());
    });
}

cl_int CL_API_CALL get_platform_info(cl_platform_id platform, cl_platform_info name,
                                     std::size_t size, void *value, std::size_t *size_ret) {
    const auto ask = [=](std::size_t room, void *to, std::size_t *size_to) {
        return driver->clGetPlatformInfo(platform, name, room, to, size_to);
    };
    if (name != CL_PLATFORM_EXTENSIONS && name != CL_PLATFORM_EXTENSIONS_WITH_VERSION) {
        return ask(size, value, size_ret);
    }
    return answer([&] {
        if (!serves_some(devices_of(platform, CL_DEVICE_TYPE_ALL))) {
            return require(ask(size, value, size_ret));
        }
        const std::string result = changed(name, bytes_of(ask));
        Query{size, value, size_ret}.give(result.data(), result.size());
    });
}

}  // namespace

void install_devices(cl_icd_dispatch &table) {
    table.clGetDeviceInfo = get_device_info;
    table.clGetPlatformInfo = get_platform_info;
}

}  // namespace stagelight
