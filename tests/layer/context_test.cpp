// SPDX-License-Identifier: MIT
// OpenCL contexts made from OpenGL contexts: cl_khr_gl_sharing, "Additions to Chapter 4".
#include "layer/sharing.h"

namespace stagelight {
namespace {

using Binding = GlWindow::Binding;
using Properties = std::vector<cl_context_properties>;

struct Where {
    const char *implementation;
    Binding binding;
};

class GlContexts : public ::testing::TestWithParam<Where> {
protected:
    GlWindow window{GetParam().binding};
    cl::Device device = device_named(GetParam().implementation);
    cl::Platform platform = platform_of(device);
    cl_context_properties platform_value = reinterpret_cast<cl_context_properties>(platform());

    cl_int code_of_create(const Properties &properties) const {
        cl_int code = CL_SUCCESS;
        const cl_context made =
            clCreateContext(properties.data(), 1, &device(), nullptr, nullptr, &code);
        EXPECT_EQ(made != nullptr, code == CL_SUCCESS);
        cl_int same = CL_SUCCESS;
        const cl_context by_type =
            clCreateContextFromType(properties.data(), CL_DEVICE_TYPE_ALL, nullptr, nullptr, &same);
        EXPECT_EQ(same, code);
        for (const cl_context each : {made, by_type}) {
            if (each != nullptr) {
                EXPECT_EQ(clReleaseContext(each), CL_SUCCESS);
            }
        }
        return code;
    }

    cl_int code_of_info(const Properties &properties) const {
        cl_device_id found = nullptr;
        return clGetGLContextInfoKHR(properties.data(), CL_CURRENT_DEVICE_FOR_GL_CONTEXT_KHR,
                                     sizeof(found), &found, nullptr);
    }

    // Properties with these beside the platform.
    Properties with(const Properties &more) const {
        Properties all{CL_CONTEXT_PLATFORM, platform_value};
        all.insert(all.end(), more.begin(), more.end());
        all.push_back(0);
        return all;
    }
};

INSTANTIATE_TEST_SUITE_P(Everywhere, GlContexts, ::testing::ValuesIn([] {
                             std::vector<Where> all;
                             for (const char *device : implementations) {
                                 all.push_back({device, Binding::glx});
                                 all.push_back({device, Binding::egl});
                             }
                             return all;
                         }()),
                         [](const auto &tested) {
                             return name_in_tests(tested.param.implementation)
                                    + (tested.param.binding == Binding::glx ? "_glx" : "_egl");
                         });

TEST_P(GlContexts, AreTakenAndGivenBack) {
    const Properties properties = window.properties(platform);
    EXPECT_EQ(code_of_create(properties), CL_SUCCESS);
    const cl::Context context(device, properties.data());
    EXPECT_EQ(context.getInfo<CL_CONTEXT_PROPERTIES>(), properties);
    EXPECT_EQ(context.getInfo<CL_CONTEXT_DEVICES>().at(0)(), device());
}

TEST_P(GlContexts, NeedNotBeCurrent) {
    GlWindow::make_none_current();
    EXPECT_EQ(code_of_create(window.properties(platform)), CL_SUCCESS);
}

TEST_P(GlContexts, AreRefusedWhenTheyAreNone) {
    // Memory that is no context, and, as after glXGetCurrentContext() without one, null.
    char nothing[256] = {};
    const auto wrong = reinterpret_cast<cl_context_properties>(nothing);
    const cl_context_properties display = window.display_property();
    GlWindow::make_none_current();
    for (const Properties &each :
         {with({CL_GL_CONTEXT_KHR, wrong, display, window.display()}),
          with({CL_GL_CONTEXT_KHR, 0, display, window.display()}),
          with({CL_GL_CONTEXT_KHR, window.context()}), with({display, window.display()})}) {
        EXPECT_EQ(code_of_create(each), CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR);
        EXPECT_EQ(code_of_info(each), CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR);
    }
}

TEST_P(GlContexts, AreRefusedWhenDestroyed) {
    cl_context_properties gone = 0;
    {
        const GlWindow other(GetParam().binding);
        gone = other.context();
    }
    window.make_current();
    if (gone == window.context()) {
        GTEST_SKIP() << "the address was used again";
    }
    EXPECT_EQ(code_of_create(
                  with({CL_GL_CONTEXT_KHR, gone, window.display_property(), window.display()})),
              CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR);
}

TEST_P(GlContexts, OfOpenGLESAreRefused) {
    const GlWindow embedded = GlWindow::of_opengl_es(GetParam().binding);
    EXPECT_EQ(code_of_create(embedded.properties(platform)),
              CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR);
}

TEST_P(GlContexts, NeedOneDisplayOfAKindThatThereIs) {
    const cl_context_properties gl = window.context();
    const cl_context_properties display = window.display();
    for (const Properties &each :
         {with({CL_GL_CONTEXT_KHR, gl, CL_EGL_DISPLAY_KHR, display, CL_GLX_DISPLAY_KHR, display}),
          with({CL_GL_CONTEXT_KHR, gl, CL_WGL_HDC_KHR, display}),
          with({CL_GL_CONTEXT_KHR, gl, CL_CGL_SHAREGROUP_KHR, display}),
          with({CL_CGL_SHAREGROUP_KHR, display})}) {
        EXPECT_EQ(code_of_create(each), CL_INVALID_OPERATION);
        EXPECT_EQ(code_of_info(each), CL_INVALID_OPERATION);
    }
}

TEST_P(GlContexts, RefuseOtherProperties) {
    const Properties gl{CL_GL_CONTEXT_KHR, window.context(), window.display_property(),
                        window.display()};
    Properties user_sync = gl;
    user_sync.insert(user_sync.end(), {CL_CONTEXT_INTEROP_USER_SYNC, CL_TRUE});
    Properties twice = gl;
    twice.insert(twice.end(), {CL_GL_CONTEXT_KHR, window.context()});
    Properties unknown = gl;
    unknown.insert(unknown.end(), {0x7777, 1});
    for (const Properties &each : {user_sync, twice, unknown}) {
        EXPECT_EQ(code_of_create(with(each)), CL_INVALID_PROPERTY);
    }
    EXPECT_EQ(code_of_info(with(unknown)), CL_INVALID_VALUE);
}

TEST_P(GlContexts, OfDefaultsAreNone) {
    EXPECT_EQ(code_of_create(with({CL_GL_CONTEXT_KHR, 0, window.display_property(), 0})),
              CL_SUCCESS);
    EXPECT_EQ(code_of_create(with({})), CL_SUCCESS);
    EXPECT_EQ(code_of_info(with({})), CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR);
}

TEST_P(GlContexts, WithoutADeviceAreNotFound) {
    cl_int code = CL_SUCCESS;
    const Properties properties = window.properties(platform);
    EXPECT_EQ(clCreateContextFromType(properties.data(), CL_DEVICE_TYPE_ACCELERATOR, nullptr,
                                      nullptr, &code),
              nullptr);
    EXPECT_EQ(code, CL_DEVICE_NOT_FOUND);
    EXPECT_EQ(clCreateContext(properties.data(), 0, nullptr, nullptr, nullptr, &code), nullptr);
    EXPECT_EQ(code, CL_INVALID_VALUE);
}

TEST_P(GlContexts, KnowTheirDevices) {
    const Properties properties = window.properties(platform);
    const auto get_info = reinterpret_cast<clGetGLContextInfoKHR_fn>(
        clGetExtensionFunctionAddressForPlatform(platform(), "clGetGLContextInfoKHR"));
    ASSERT_NE(get_info, nullptr);
    for (const auto name : std::initializer_list<cl_gl_context_info>{
             CL_CURRENT_DEVICE_FOR_GL_CONTEXT_KHR, CL_DEVICES_FOR_GL_CONTEXT_KHR}) {
        cl_device_id found = nullptr;
        std::size_t size = 0;
        EXPECT_EQ(get_info(properties.data(), name, sizeof(found), &found, &size), CL_SUCCESS);
        EXPECT_EQ(found, device());
        EXPECT_EQ(size, sizeof(found));
        EXPECT_EQ(get_info(properties.data(), name, 1, &found, nullptr), CL_INVALID_VALUE);
    }
    EXPECT_EQ(get_info(properties.data(), 0, 0, nullptr, nullptr), CL_INVALID_VALUE);
    EXPECT_EQ(code_of_info({CL_GL_CONTEXT_KHR, window.context(), 0}), CL_INVALID_PLATFORM);
    EXPECT_EQ(code_of_info(properties), CL_SUCCESS);  // the loader's own symbol
}

TEST_P(GlContexts, AreNeededToShare) {
    const cl::Context plain(device);
    const cl::CommandQueue queue(plain, device);
    const GLuint texture = make_texture(4, 4, {});
    const GLuint buffer = make_buffer(Bytes(16));
    cl_int code = CL_SUCCESS;
    EXPECT_EQ(clCreateFromGLTexture(plain(), CL_MEM_READ_WRITE, GL_TEXTURE_2D, 0, texture, &code),
              nullptr);
    EXPECT_EQ(code, CL_INVALID_CONTEXT);
    EXPECT_EQ(clCreateFromGLBuffer(plain(), CL_MEM_READ_WRITE, buffer, &code), nullptr);
    EXPECT_EQ(code, CL_INVALID_CONTEXT);
    EXPECT_EQ(clCreateFromGLRenderbuffer(plain(), CL_MEM_READ_WRITE, 1, &code), nullptr);
    EXPECT_EQ(code, CL_INVALID_CONTEXT);
    EXPECT_EQ(clCreateEventFromGLsyncKHR(plain(), nullptr, &code), nullptr);
    EXPECT_EQ(code, CL_INVALID_CONTEXT);
    EXPECT_EQ(clCreateFromGLTexture(nullptr, CL_MEM_READ_WRITE, GL_TEXTURE_2D, 0, texture, &code),
              nullptr);
    EXPECT_EQ(code, CL_INVALID_CONTEXT);
    const cl::Buffer memory(plain, CL_MEM_READ_WRITE, 16);
    EXPECT_EQ(clEnqueueAcquireGLObjects(queue(), 1, &memory(), 0, nullptr, nullptr),
              CL_INVALID_CONTEXT);
    EXPECT_EQ(clEnqueueReleaseGLObjects(queue(), 1, &memory(), 0, nullptr, nullptr),
              CL_INVALID_CONTEXT);
}

}  // namespace
}  // namespace stagelight
