// SPDX-License-Identifier: MIT
// What the loader calls: clGetLayerInfo and clInitLayer ("Installable OpenCL Loader Layers" of the
// OpenCL Extension Specification), and the way to the extension's functions by their names.
#include "layer.h"

#include <cstdlib>
#include <cstring>

#include <CL/cl_layer.h>

#include "contexts.h"
#include "driver.h"
#include "events.h"
#include "kernels.h"
#include "objects.h"
#include "refusal.h"

#define EXPORTED extern "C" __attribute__((visibility("default")))

namespace stagelight {
namespace {

constexpr char layer_name[] = "Stagelight GL sharing by copying";

// What the layer does not have stays null, and the loader takes it from below.
cl_icd_dispatch ours{};

template <typename Function> void *address(Function *function) {
    return reinterpret_cast<void *>(function);
}

struct Named {
    const char *name;
    void *function;
};

void *shared_function(const char *name) {
    const Named all[] = {
        {"clGetGLContextInfoKHR", address(ours.clGetGLContextInfoKHR)},
        {"clCreateFromGLBuffer", address(ours.clCreateFromGLBuffer)},
        {"clCreateFromGLTexture", address(ours.clCreateFromGLTexture)},
        {"clCreateFromGLTexture2D", address(ours.clCreateFromGLTexture2D)},
        {"clCreateFromGLTexture3D", address(ours.clCreateFromGLTexture3D)},
        {"clCreateFromGLRenderbuffer", address(ours.clCreateFromGLRenderbuffer)},
        {"clGetGLObjectInfo", address(ours.clGetGLObjectInfo)},
        {"clGetGLTextureInfo", address(ours.clGetGLTextureInfo)},
        {"clEnqueueAcquireGLObjects", address(ours.clEnqueueAcquireGLObjects)},
        {"clEnqueueReleaseGLObjects", address(ours.clEnqueueReleaseGLObjects)},
        {"clCreateEventFromGLsyncKHR", address(ours.clCreateEventFromGLsyncKHR)},
    };
    for (const Named &each : all) {
        if (name != nullptr && std::strcmp(each.name, name) == 0) {
            return each.function;
        }
    }
    return nullptr;
}

// The functions pass on what a driver shares itself, so they serve every platform.
void *CL_API_CALL get_function(const char *name) {
    void *found = shared_function(name);
    return found != nullptr ? found : driver->clGetExtensionFunctionAddress(name);
}

void *CL_API_CALL get_platform_function(cl_platform_id platform, const char *name) {
    void *found = shared_function(name);
    return found != nullptr ? found
                            : driver->clGetExtensionFunctionAddressForPlatform(platform, name);
}

void install_all() {
    install_devices(ours);
    install_contexts(ours);
    install_objects(ours);
    install_object_info(ours);
    install_derived_objects(ours);
    install_transfers(ours);
    install_events(ours);
    install_kernels(ours);
    install_commands(ours);
    ours.clGetExtensionFunctionAddress = get_function;
    ours.clGetExtensionFunctionAddressForPlatform = get_platform_function;
}

}  // namespace

bool offers_gl_event() {
    static const char *const wish = std::getenv("STAGELIGHT_LAYER_GL_EVENT");
    static const bool offered = wish == nullptr || std::strcmp(wish, "0") != 0;
    return offered;
}

}  // namespace stagelight

using namespace stagelight;

EXPORTED cl_int CL_API_CALL clGetLayerInfo(cl_layer_info name, size_t size, void *value,
                                           size_t *size_ret) {
    return answer([&] {
        const Query query{size, value, size_ret};
        const cl_layer_api_version version = CL_LAYER_API_VERSION_100;
        switch (name) {
        case CL_LAYER_API_VERSION:
            return query.give(&version, sizeof(version));
        case CL_LAYER_NAME:
            return query.give(layer_name, sizeof(layer_name));
        default:
            throw Refusal{CL_INVALID_VALUE, {}};
        }
    });
}

EXPORTED cl_int CL_API_CALL clInitLayer(cl_uint entries, const cl_icd_dispatch *target,
                                        cl_uint *entries_ret, const cl_icd_dispatch **table_ret) {
    constexpr cl_uint needed = sizeof(cl_icd_dispatch) / sizeof(void *);
    if (target == nullptr || entries_ret == nullptr || table_ret == nullptr || entries < needed) {
        return CL_INVALID_VALUE;
    }
    driver = target;
    install_all();
    *entries_ret = needed;
    *table_ret = &ours;
    return CL_SUCCESS;
}

// For tests: how much the layer remembers at the moment.
EXPORTED size_t stagelight_gl_sharing_records() {
    return contexts.size() + objects.size() + events.size() + kernels.size();
}
