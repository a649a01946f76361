// SPDX-License-Identifier: MIT
#include "layer/sharing.h"

#include <algorithm>
#include <cctype>
#include <random>
#include <stdexcept>

namespace stagelight {
namespace {

cl::Memory wrapped(Made made) {
    if (made.second != CL_SUCCESS) {
        throw std::runtime_error("not shared: " + std::to_string(made.second));
    }
    return cl::Memory(made.first, false);
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

}  // namespace

Bytes random_bytes(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    Bytes bytes(count);
    std::ranges::generate(bytes, [&] { return static_cast<unsigned char>(random()); });
    return bytes;
}

// By a part of what --list-devices says, upper and lower case alike.
cl::Device device_named(const std::string &part) {
    std::vector<cl::Platform> platforms;
    cl::Platform::get(&platforms);
    for (const cl::Platform &platform : platforms) {
        cl_device_id device = nullptr;
        if (clGetDeviceIDs(platform(), CL_DEVICE_TYPE_ALL, 1, &device, nullptr) == CL_SUCCESS) {
            cl::Device found(device, true);
            const std::string description = found.getInfo<CL_DEVICE_NAME>() + ' '
                                            + platform.getInfo<CL_PLATFORM_NAME>() + ' '
                                            + found.getInfo<CL_DEVICE_VERSION>();
            if (lower(description).find(lower(part)) != std::string::npos) {
                return found;
            }
        }
    }
    throw std::runtime_error("no OpenCL device of the name " + part);
}

Sharing::Sharing(const std::string &implementation, GlWindow::Binding binding)
    : window(binding), device(device_named(implementation)), platform(platform_of(device)),
      context(device, window.properties(platform).data()), queue(context, device) {}

Made Sharing::make(GLuint texture, GLenum target, GLint level, cl_mem_flags flags) const {
    cl_int code = CL_SUCCESS;
    const cl_mem made = clCreateFromGLTexture(context(), flags, target, level, texture, &code);
    return {made, code};
}

cl::Memory Sharing::share(GLuint texture, GLenum target, GLint level) const {
    return wrapped(make(texture, target, level));
}

cl::Memory Sharing::share_buffer(GLuint buffer) const {
    cl_int code = CL_SUCCESS;
    const cl_mem made = clCreateFromGLBuffer(context(), CL_MEM_READ_WRITE, buffer, &code);
    return wrapped({made, code});
}

cl_int Sharing::acquire(const cl::Memory &object, cl_event *event) const {
    return clEnqueueAcquireGLObjects(queue(), 1, &object(), 0, nullptr, event);
}

cl_int Sharing::release(const cl::Memory &object, cl_event *event) const {
    return clEnqueueReleaseGLObjects(queue(), 1, &object(), 0, nullptr, event);
}

Bytes Sharing::read_image(const cl::Memory &image, std::size_t pixel,
                          const std::array<std::size_t, 3> &size) const {
    Bytes bytes(size[0] * size[1] * size[2] * pixel);
    const std::size_t origin[3] = {0, 0, 0};
    const cl_int code = clEnqueueReadImage(queue(), image(), CL_TRUE, origin, size.data(), 0, 0,
                                           bytes.data(), 0, nullptr, nullptr);
    EXPECT_EQ(code, CL_SUCCESS);
    return bytes;
}

void Sharing::write_image(const cl::Memory &image, const Bytes &bytes,
                          const std::array<std::size_t, 3> &size) const {
    const std::size_t origin[3] = {0, 0, 0};
    const cl_int code = clEnqueueWriteImage(queue(), image(), CL_TRUE, origin, size.data(), 0, 0,
                                            bytes.data(), 0, nullptr, nullptr);
    EXPECT_EQ(code, CL_SUCCESS);
}

bool Sharing::supports(const cl::ImageFormat &format) const {
    std::vector<cl::ImageFormat> formats;
    context.getSupportedImageFormats(CL_MEM_READ_WRITE, CL_MEM_OBJECT_IMAGE2D, &formats);
    return std::ranges::any_of(formats, [&](const cl::ImageFormat &each) {
        return each.image_channel_order == format.image_channel_order
               && each.image_channel_data_type == format.image_channel_data_type;
    });
}

GLuint make_texture(GLsizei width, GLsizei height, const Bytes &pixels) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels.empty() ? nullptr : pixels.data());
    return texture;
}

Bytes texture_pixels(GLuint texture, std::size_t bytes) {
    Bytes pixels(bytes);
    glGetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes),
                      pixels.data());
    return pixels;
}

GLuint make_buffer(const Bytes &contents) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(contents.size()), contents.data(),
                 GL_DYNAMIC_DRAW);
    return buffer;
}

}  // namespace stagelight
