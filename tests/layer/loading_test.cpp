// SPDX-License-Identifier: MIT
// What programs see of the layer before they share anything.
#include <cstring>

#include <CL/cl_layer.h>
#include <dlfcn.h>

#include "layer/sharing.h"

namespace stagelight {
namespace {

constexpr cl_uint extensions_with_version = 0x1060;           // of OpenCL 3.0
constexpr cl_uint platform_extensions_with_version = 0x0907;  // of OpenCL 3.0
struct NameVersion {                                          // cl_name_version
    cl_uint version;
    char name[64];
};

bool has_word(const std::string &list, const std::string &word) {
    return (' ' + list + ' ').find(' ' + word + ' ') != std::string::npos;
}

// Both queries work with `ask`: size and value, as OpenCL's do.
template <typename Ask> std::vector<NameVersion> versioned(Ask ask) {
    std::size_t size = 0;
    EXPECT_EQ(ask(0, nullptr, &size), CL_SUCCESS);
    EXPECT_EQ(size % sizeof(NameVersion), 0U);
    std::vector<NameVersion> all(size / sizeof(NameVersion));
    EXPECT_EQ(ask(size, all.data(), nullptr), CL_SUCCESS);
    return all;
}

int count_of(const std::vector<NameVersion> &all, const char *name) {
    int count = 0;
    for (const NameVersion &each : all) {
        count += std::strcmp(each.name, name) == 0 && each.version == (1U << 22);
    }
    return count;
}

using Loading = OnEach;
STAGELIGHT_ON_EACH(Loading);

TEST_P(Loading, NamesTheExtensionsAndSaysThatItCopies) {
    const cl::Device device = device_named(GetParam());
    const cl::Platform platform = platform_of(device);
    for (const char *name : {"cl_khr_gl_sharing", "cl_khr_gl_event"}) {
        EXPECT_TRUE(has_word(device.getInfo<CL_DEVICE_EXTENSIONS>(), name)) << name;
        EXPECT_TRUE(has_word(platform.getInfo<CL_PLATFORM_EXTENSIONS>(), name)) << name;
    }
    EXPECT_TRUE(device.getInfo<CL_DEVICE_NAME>().ends_with(" (GL sharing by copying)"));
    EXPECT_TRUE(has_word(device.getInfo<CL_DEVICE_EXTENSIONS>(), "cl_khr_byte_addressable_store"));
}

TEST_P(Loading, NamesThemWithVersionsOnce) {
    const cl::Device device = device_named(GetParam());
    const auto of_device = versioned([&](std::size_t size, void *value, std::size_t *size_ret) {
        return clGetDeviceInfo(device(), extensions_with_version, size, value, size_ret);
    });
    const cl_platform_id platform = platform_of(device)();
    const auto of_platform = versioned([&](std::size_t size, void *value, std::size_t *size_ret) {
        return clGetPlatformInfo(platform, platform_extensions_with_version, size, value, size_ret);
    });
    for (const char *name : {"cl_khr_gl_sharing", "cl_khr_gl_event"}) {
        EXPECT_EQ(count_of(of_device, name), 1) << name;
        EXPECT_EQ(count_of(of_platform, name), 1) << name;
    }
}

TEST_P(Loading, TellsTheRoomThatAnAnswerNeeds) {
    const cl::Device device = device_named(GetParam());
    std::size_t size = 0;
    ASSERT_EQ(clGetDeviceInfo(device(), CL_DEVICE_NAME, 0, nullptr, &size), CL_SUCCESS);
    std::string name(size, 'x');
    EXPECT_EQ(clGetDeviceInfo(device(), CL_DEVICE_NAME, size - 1, name.data(), nullptr),
              CL_INVALID_VALUE);
    ASSERT_EQ(clGetDeviceInfo(device(), CL_DEVICE_NAME, size, name.data(), nullptr), CL_SUCCESS);
    EXPECT_EQ(std::strlen(name.c_str()), size - 1);
}

TEST_P(Loading, FunctionsAreFoundByName) {
    const cl_platform_id platform = platform_of(device_named(GetParam()))();
    for (const char *name :
         {"clGetGLContextInfoKHR", "clCreateFromGLBuffer", "clCreateFromGLTexture",
          "clCreateFromGLTexture2D", "clCreateFromGLTexture3D", "clCreateFromGLRenderbuffer",
          "clGetGLObjectInfo", "clGetGLTextureInfo", "clEnqueueAcquireGLObjects",
          "clEnqueueReleaseGLObjects", "clCreateEventFromGLsyncKHR"}) {
        void *const found = clGetExtensionFunctionAddressForPlatform(platform, name);
        ASSERT_NE(found, nullptr) << name;
        EXPECT_EQ(found, clGetExtensionFunctionAddress(name)) << name;
        Dl_info where{};
        ASSERT_NE(dladdr(found, &where), 0);
        EXPECT_STREQ(where.dli_fname, STAGELIGHT_LAYER) << name;
    }
    EXPECT_EQ(clGetExtensionFunctionAddressForPlatform(platform, "clNoSuchThingKHR"), nullptr);
    EXPECT_EQ(clGetExtensionFunctionAddress(nullptr), nullptr);
}

TEST(LayerLibrary, TellsItsNameAndVersion) {
    void *const library = dlopen(STAGELIGHT_LAYER, RTLD_LAZY);
    ASSERT_NE(library, nullptr);
    const auto get_info = reinterpret_cast<pfn_clGetLayerInfo>(dlsym(library, "clGetLayerInfo"));
    ASSERT_NE(get_info, nullptr);
    cl_layer_api_version version = 0;
    EXPECT_EQ(get_info(CL_LAYER_API_VERSION, sizeof(version), &version, nullptr), CL_SUCCESS);
    EXPECT_EQ(version, static_cast<cl_layer_api_version>(CL_LAYER_API_VERSION_100));
    char name[100] = "";
    EXPECT_EQ(get_info(CL_LAYER_NAME, sizeof(name), name, nullptr), CL_SUCCESS);
    EXPECT_NE(std::string(name).find("copying"), std::string::npos) << name;
    EXPECT_EQ(get_info(0, sizeof(name), name, nullptr), CL_INVALID_VALUE);
    dlclose(library);
}

TEST(LayerLibrary, RefusesALoaderThatKnowsFewerFunctions) {
    void *const library = dlopen(STAGELIGHT_LAYER, RTLD_LAZY);
    ASSERT_NE(library, nullptr);
    const auto init = reinterpret_cast<pfn_clInitLayer>(dlsym(library, "clInitLayer"));
    ASSERT_NE(init, nullptr);
    const cl_icd_dispatch below{};
    const cl_icd_dispatch *table = nullptr;
    cl_uint entries = 0;
    EXPECT_EQ(init(10, &below, &entries, &table), CL_INVALID_VALUE);
    EXPECT_EQ(init(1000, nullptr, &entries, &table), CL_INVALID_VALUE);
    EXPECT_EQ(init(1000, &below, nullptr, &table), CL_INVALID_VALUE);
    EXPECT_EQ(init(1000, &below, &entries, nullptr), CL_INVALID_VALUE);
    dlclose(library);
}

}  // namespace
}  // namespace stagelight
