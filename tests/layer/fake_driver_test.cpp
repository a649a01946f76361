// SPDX-License-Identifier: MIT
// The layer above a driver that this file makes up: it says what no driver of the packages says.
#include <cstring>
#include <string>
#include <vector>

#include <CL/cl_icd.h>
#include <CL/cl_layer.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

namespace stagelight {
namespace {

struct Driver {
    std::string version = "OpenCL 3.0 fake";
    std::string extensions;
} driver;

cl_int give(const void *data, std::size_t bytes, std::size_t size, void *value,
            std::size_t *size_ret) {
    if (value != nullptr && size < bytes) {
        return CL_INVALID_VALUE;
    }
    if (value != nullptr) {
        std::memcpy(value, data, bytes);
    }
    if (size_ret != nullptr) {
        *size_ret = bytes;
    }
    return CL_SUCCESS;
}

// The words of `extensions`.
std::vector<cl_name_version> versioned_extensions() {
    std::vector<cl_name_version> all;
    std::string words = driver.extensions + ' ';
    for (std::size_t end = 0; (end = words.find(' ')) != std::string::npos;
         words.erase(0, end + 1)) {
        if (end > 0) {
            all.push_back({CL_MAKE_VERSION(1, 0, 0), {}});
            words.copy(all.back().name, end);
        }
    }
    return all;
}

cl_int CL_API_CALL get_device_info(cl_device_id, cl_device_info name, std::size_t size, void *value,
                                   std::size_t *size_ret) {
    if (name == CL_DEVICE_EXTENSIONS_WITH_VERSION) {
        const std::vector<cl_name_version> all = versioned_extensions();
        return give(all.data(), all.size() * sizeof all[0], size, value, size_ret);
    }
    const std::string text = name == CL_DEVICE_NAME         ? "Fake"
                             : name == CL_DEVICE_EXTENSIONS ? driver.extensions
                                                            : driver.version;
    return give(text.c_str(), text.size() + 1, size, value, size_ret);
}

cl_int CL_API_CALL get_platform_info(cl_platform_id, cl_platform_info name, std::size_t size,
                                     void *value, std::size_t *size_ret) {
    return get_device_info(nullptr,
                           name == CL_PLATFORM_EXTENSIONS ? CL_DEVICE_EXTENSIONS
                                                          : CL_DEVICE_EXTENSIONS_WITH_VERSION,
                           size, value, size_ret);
}

cl_int CL_API_CALL get_device_ids(cl_platform_id, cl_device_type, cl_uint, cl_device_id *devices,
                                  cl_uint *count) {
    if (devices != nullptr) {
        devices[0] = nullptr;
    }
    if (count != nullptr) {
        *count = 1;
    }
    return CL_SUCCESS;
}

cl_int CL_API_CALL refuse_event(cl_event) {
    return CL_INVALID_EVENT;
}

class FakeDriver : public testing::Test {
protected:
    FakeDriver() {
        driver = {};
        below_.clGetDeviceInfo = get_device_info;
        below_.clGetPlatformInfo = get_platform_info;
        below_.clGetDeviceIDs = get_device_ids;
        below_.clRetainEvent = refuse_event;
        below_.clReleaseEvent = refuse_event;
        library_ = dlopen(STAGELIGHT_LAYER, RTLD_NOW);
        const auto init = reinterpret_cast<pfn_clInitLayer>(dlsym(library_, "clInitLayer"));
        constexpr cl_uint entries = sizeof(cl_icd_dispatch) / sizeof(void *);
        cl_uint count = 0;
        EXPECT_EQ(init(entries, &below_, &count, &layer_), CL_SUCCESS);
        EXPECT_EQ(count, entries);
    }
    ~FakeDriver() override { dlclose(library_); }

    std::string device_text(cl_device_info name) const {
        std::string text(400, 'x');
        EXPECT_EQ(layer_->clGetDeviceInfo(nullptr, name, text.size(), text.data(), nullptr),
                  CL_SUCCESS);
        return text.c_str();
    }
    std::string platform_extensions() const {
        std::string text(400, 'x');
        EXPECT_EQ(layer_->clGetPlatformInfo(nullptr, CL_PLATFORM_EXTENSIONS, text.size(),
                                            text.data(), nullptr),
                  CL_SUCCESS);
        return text.c_str();
    }
    // As a list of words.
    std::string versioned() const {
        std::size_t size = 0;
        layer_->clGetDeviceInfo(nullptr, CL_DEVICE_EXTENSIONS_WITH_VERSION, 0, nullptr, &size);
        std::vector<cl_name_version> all(size / sizeof(cl_name_version));
        layer_->clGetDeviceInfo(nullptr, CL_DEVICE_EXTENSIONS_WITH_VERSION, size, all.data(),
                                nullptr);
        std::string words;
        for (const cl_name_version &each : all) {
            EXPECT_EQ(each.version, CL_MAKE_VERSION(1, 0, 0));
            words += (words.empty() ? "" : " ") + std::string(each.name);
        }
        return words;
    }

    const cl_icd_dispatch *layer_ = nullptr;

private:
    cl_icd_dispatch below_{};
    void *library_ = nullptr;
};

TEST_F(FakeDriver, ExtensionsThatItHasAreNotNamedTwice) {
    const std::pair<const char *, const char *> lists[] = {
        {"", "cl_khr_gl_sharing cl_khr_gl_event"},
        {"cl_khr_fp64", "cl_khr_fp64 cl_khr_gl_sharing cl_khr_gl_event"},
        {"cl_khr_fp64 ", "cl_khr_fp64 cl_khr_gl_sharing cl_khr_gl_event"},
        {"cl_khr_gl_event cl_khr_fp64", "cl_khr_gl_event cl_khr_fp64 cl_khr_gl_sharing"},
        {"cl_khr_gl_events", "cl_khr_gl_events cl_khr_gl_sharing cl_khr_gl_event"},
    };
    for (const auto &[has, named] : lists) {
        driver.extensions = has;
        EXPECT_EQ(device_text(CL_DEVICE_EXTENSIONS), named);
        EXPECT_EQ(platform_extensions(), named);
        EXPECT_EQ(versioned(), named);
        EXPECT_EQ(device_text(CL_DEVICE_NAME), "Fake (GL sharing by copying)");
    }
}

// One that shares itself, and one of before OpenCL 1.2.
TEST_F(FakeDriver, IsLeftAloneWhereItCannotBeServed) {
    driver.extensions = "cl_khr_gl_sharing";
    EXPECT_EQ(device_text(CL_DEVICE_EXTENSIONS), "cl_khr_gl_sharing");
    EXPECT_EQ(platform_extensions(), "cl_khr_gl_sharing");
    EXPECT_EQ(versioned(), "cl_khr_gl_sharing");
    EXPECT_EQ(device_text(CL_DEVICE_NAME), "Fake");
    driver = {.version = "OpenCL 1.1 fake", .extensions = "cl_khr_fp64"};
    EXPECT_EQ(device_text(CL_DEVICE_EXTENSIONS), "cl_khr_fp64");
    EXPECT_EQ(device_text(CL_DEVICE_NAME), "Fake");
    driver.version = "OpenCL 1.2 fake";
    EXPECT_EQ(device_text(CL_DEVICE_NAME), "Fake (GL sharing by copying)");
}

TEST_F(FakeDriver, SaysItselfThatAnEventIsNone) {
    EXPECT_EQ(layer_->clRetainEvent(nullptr), CL_INVALID_EVENT);
    EXPECT_EQ(layer_->clReleaseEvent(nullptr), CL_INVALID_EVENT);
}

}  // namespace
}  // namespace stagelight
