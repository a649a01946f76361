// SPDX-License-Identifier: MIT
// A window and an OpenCL context that share through the layer, and what tests do with them.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "implementations.h"
#include "layer/gl_window.h"

namespace stagelight {

// The loader reads it at the first call into OpenCL.
inline const bool layer_named = setenv("OPENCL_LAYERS", STAGELIGHT_LAYER, 1) == 0;

using Bytes = std::vector<unsigned char>;
// Every bit pattern may occur.
Bytes random_bytes(std::size_t count, unsigned seed);

// The device whose name has this part. Throws std::runtime_error when there is none.
cl::Device device_named(const std::string &part);

// A handle, or null, with the code that came with it.
using Made = std::pair<cl_mem, cl_int>;

struct Sharing {
    explicit Sharing(const std::string &implementation,
                     GlWindow::Binding binding = GlWindow::Binding::glx);

    GlWindow window;
    cl::Device device;
    cl::Platform platform;
    cl::Context context;
    cl::CommandQueue queue;

    Made make(GLuint texture, GLenum target = GL_TEXTURE_2D, GLint level = 0,
              cl_mem_flags flags = CL_MEM_READ_WRITE) const;
    // Throws std::runtime_error with the code when it cannot be shared.
    cl::Memory share(GLuint texture, GLenum target = GL_TEXTURE_2D, GLint level = 0) const;
    cl::Memory share_buffer(GLuint buffer) const;
    cl_int acquire(const cl::Memory &object, cl_event *event = nullptr) const;
    cl_int release(const cl::Memory &object, cl_event *event = nullptr) const;
    // `pixel`: bytes; `size`: width, height and depth.
    Bytes read_image(const cl::Memory &image, std::size_t pixel,
                     const std::array<std::size_t, 3> &size) const;
    void write_image(const cl::Memory &image, const Bytes &bytes,
                     const std::array<std::size_t, 3> &size) const;
    bool supports(const cl::ImageFormat &format) const;
};

// A texture of RGBA8 with nearest filters. It stays bound to GL_TEXTURE_2D.
GLuint make_texture(GLsizei width, GLsizei height, const Bytes &pixels);
Bytes texture_pixels(GLuint texture, std::size_t bytes);
GLuint make_buffer(const Bytes &contents);

// Tests that run on each of the implementations, which they get by the names' parts.
class OnEach : public ::testing::TestWithParam<const char *> {};
#define STAGELIGHT_ON_EACH(suite)                                                          \
    INSTANTIATE_TEST_SUITE_P(Implementations, suite, ::testing::ValuesIn(implementations), \
                             [](const auto &tested) { return name_in_tests(tested.param); })

}  // namespace stagelight
