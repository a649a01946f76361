// SPDX-License-Identifier: MIT
// Textures that are not flat, renderbuffers and buffers go both ways too.
#include "layer/sharing.h"

namespace stagelight {
namespace {

using Targets = OnEach;
STAGELIGHT_ON_EACH(Targets);

using Size = std::array<std::size_t, 3>;

struct Shape {
    GLenum target;  // what is shared
    GLenum bound;   // what the texture is
    Size size;
    cl_mem_object_type image;
    cl_gl_object_type object;
};

constexpr Shape shapes[] = {
    {GL_TEXTURE_1D, GL_TEXTURE_1D, {7, 1, 1}, CL_MEM_OBJECT_IMAGE1D, CL_GL_OBJECT_TEXTURE1D},
    {GL_TEXTURE_1D_ARRAY,
     GL_TEXTURE_1D_ARRAY,
     {7, 3, 1},
     CL_MEM_OBJECT_IMAGE1D_ARRAY,
     CL_GL_OBJECT_TEXTURE1D_ARRAY},
    {GL_TEXTURE_2D, GL_TEXTURE_2D, {7, 5, 1}, CL_MEM_OBJECT_IMAGE2D, CL_GL_OBJECT_TEXTURE2D},
    {GL_TEXTURE_RECTANGLE,
     GL_TEXTURE_RECTANGLE,
     {7, 5, 1},
     CL_MEM_OBJECT_IMAGE2D,
     CL_GL_OBJECT_TEXTURE2D},
    {GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
     GL_TEXTURE_CUBE_MAP,
     {6, 6, 1},
     CL_MEM_OBJECT_IMAGE2D,
     CL_GL_OBJECT_TEXTURE2D},
    {GL_TEXTURE_2D_ARRAY,
     GL_TEXTURE_2D_ARRAY,
     {7, 5, 3},
     CL_MEM_OBJECT_IMAGE2D_ARRAY,
     CL_GL_OBJECT_TEXTURE2D_ARRAY},
    {GL_TEXTURE_3D, GL_TEXTURE_3D, {7, 5, 3}, CL_MEM_OBJECT_IMAGE3D, CL_GL_OBJECT_TEXTURE3D},
};

void define(const Shape &shape, GLenum target, const Bytes &pixels) {
    const auto [width, height, depth] = shape.size;
    const auto w = static_cast<GLsizei>(width);
    const auto h = static_cast<GLsizei>(height);
    const auto d = static_cast<GLsizei>(depth);
    if (shape.bound == GL_TEXTURE_1D) {
        glTexImage1D(target, 0, GL_RGBA8, w, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    } else if (shape.bound == GL_TEXTURE_2D_ARRAY || shape.bound == GL_TEXTURE_3D) {
        glTexImage3D(target, 0, GL_RGBA8, w, h, d, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    } else {
        glTexImage2D(target, 0, GL_RGBA8, w, h, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    }
}

GLuint make_shape(const Shape &shape, const Bytes &pixels) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(shape.bound, texture);
    glTexParameteri(shape.bound, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    for (GLenum i = 0; shape.bound == GL_TEXTURE_CUBE_MAP && i < 6; ++i) {
        define(shape, GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, Bytes(pixels.size()));
    }
    define(shape, shape.target, pixels);
    return texture;
}

TEST_P(Targets, GoBothWays) {
    const Sharing sharing(GetParam());
    for (const Shape &shape : shapes) {
        SCOPED_TRACE(::testing::Message() << "target " << std::hex << shape.target);
        const std::size_t count = shape.size[0] * shape.size[1] * shape.size[2] * 4;
        const Bytes from_gl = random_bytes(count, 1);
        const Bytes from_cl = random_bytes(count, 2);
        const GLuint texture = make_shape(shape, from_gl);
        const cl::Memory image = sharing.share(texture, shape.target);
        ASSERT_EQ(sharing.acquire(image), CL_SUCCESS);
        EXPECT_EQ(sharing.read_image(image, 4, shape.size), from_gl);
        sharing.write_image(image, from_cl, shape.size);
        ASSERT_EQ(sharing.release(image), CL_SUCCESS);
        Bytes now(count);
        glBindTexture(shape.bound, texture);
        glGetTexImage(shape.target, 0, GL_RGBA, GL_UNSIGNED_BYTE, now.data());
        EXPECT_EQ(now, from_cl);
    }
}

TEST_P(Targets, AreTold) {
    const Sharing sharing(GetParam());
    for (const Shape &shape : shapes) {
        SCOPED_TRACE(::testing::Message() << "target " << std::hex << shape.target);
        const std::size_t count = shape.size[0] * shape.size[1] * shape.size[2] * 4;
        const GLuint texture = make_shape(shape, Bytes(count));
        const cl::Memory image = sharing.share(texture, shape.target);
        EXPECT_EQ(image.getInfo<CL_MEM_TYPE>(), shape.image);
        cl_gl_object_type type = 0;
        GLuint name = 0;
        EXPECT_EQ(clGetGLObjectInfo(image(), &type, &name), CL_SUCCESS);
        EXPECT_EQ(type, shape.object);
        EXPECT_EQ(name, texture);
        EXPECT_EQ(clGetGLObjectInfo(image(), nullptr, nullptr), CL_SUCCESS);
        GLenum target = 0;
        GLint level = 77;
        EXPECT_EQ(
            clGetGLTextureInfo(image(), CL_GL_TEXTURE_TARGET, sizeof(target), &target, nullptr),
            CL_SUCCESS);
        EXPECT_EQ(target, shape.target);
        EXPECT_EQ(clGetGLTextureInfo(image(), CL_GL_MIPMAP_LEVEL, sizeof(level), &level, nullptr),
                  CL_SUCCESS);
        EXPECT_EQ(level, 0);
    }
}

GLuint make_renderbuffer(GLenum internal, GLsizei width, GLsizei height, GLsizei samples = 0) {
    GLuint renderbuffer = 0;
    glGenRenderbuffers(1, &renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, internal, width, height);
    return renderbuffer;
}

TEST_P(Targets, RenderbuffersGoBothWays) {
    const Sharing sharing(GetParam());
    const GLuint renderbuffer = make_renderbuffer(GL_RGBA8, 7, 5);
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
    glClearColor(1.0F, 0.0F, 0.2F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    cl_int code = CL_SUCCESS;
    const cl::Memory image(
        clCreateFromGLRenderbuffer(sharing.context(), CL_MEM_READ_WRITE, renderbuffer, &code),
        false);
    ASSERT_EQ(code, CL_SUCCESS);
    ASSERT_EQ(sharing.acquire(image), CL_SUCCESS);
    const Bytes drawn = sharing.read_image(image, 4, {7, 5, 1});
    EXPECT_EQ(Bytes(drawn.end() - 4, drawn.end()), (Bytes{255, 0, 51, 255}));
    const Bytes from_cl = random_bytes(7 * 5 * 4, 2);
    sharing.write_image(image, from_cl, {7, 5, 1});
    ASSERT_EQ(sharing.release(image), CL_SUCCESS);
    Bytes now(from_cl.size());
    glReadPixels(0, 0, 7, 5, GL_RGBA, GL_UNSIGNED_BYTE, now.data());
    EXPECT_EQ(now, from_cl);
    cl_gl_object_type type = 0;
    EXPECT_EQ(clGetGLObjectInfo(image(), &type, nullptr), CL_SUCCESS);
    EXPECT_EQ(type, static_cast<cl_gl_object_type>(CL_GL_OBJECT_RENDERBUFFER));
    EXPECT_EQ(clGetGLTextureInfo(image(), CL_GL_MIPMAP_LEVEL, 0, nullptr, nullptr),
              CL_INVALID_GL_OBJECT);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 8, 5);
    EXPECT_EQ(sharing.acquire(image), CL_INVALID_GL_OBJECT);
}

TEST_P(Targets, RenderbuffersThatCannotBeShared) {
    const Sharing sharing(GetParam());
    const auto code_of = [&](GLuint renderbuffer) {
        cl_int code = CL_SUCCESS;
        clCreateFromGLRenderbuffer(sharing.context(), CL_MEM_READ_WRITE, renderbuffer, &code);
        return code;
    };
    GLuint without_storage = 0;
    glGenRenderbuffers(1, &without_storage);
    glBindRenderbuffer(GL_RENDERBUFFER, without_storage);
    EXPECT_EQ(code_of(0), CL_INVALID_GL_OBJECT);
    EXPECT_EQ(code_of(4711), CL_INVALID_GL_OBJECT);
    EXPECT_EQ(code_of(without_storage), CL_INVALID_GL_OBJECT);
    EXPECT_EQ(code_of(make_renderbuffer(GL_RGBA8, 4, 4, 4)), CL_INVALID_OPERATION);
    EXPECT_EQ(code_of(make_renderbuffer(GL_DEPTH_COMPONENT24, 4, 4)),
              CL_INVALID_IMAGE_FORMAT_DESCRIPTOR);
}

TEST_P(Targets, BuffersGoBothWays) {
    const Sharing sharing(GetParam());
    const Bytes from_gl = random_bytes(1001, 1);
    const Bytes from_cl = random_bytes(1001, 2);
    GLuint fixed = 0;  // glBufferSubData is refused on this one
    glGenBuffers(1, &fixed);
    glBindBuffer(GL_ARRAY_BUFFER, fixed);
    glBufferStorage(GL_ARRAY_BUFFER, 1001, from_gl.data(), 0);
    for (const GLuint buffer : {make_buffer(from_gl), fixed}) {
        const cl::Memory memory = sharing.share_buffer(buffer);
        EXPECT_EQ(memory.getInfo<CL_MEM_SIZE>(), 1001U);
        const cl::Buffer shared(memory(), true);
        Bytes seen(1001);
        ASSERT_EQ(sharing.acquire(memory), CL_SUCCESS);
        sharing.queue.enqueueReadBuffer(shared, CL_TRUE, 0, 1001, seen.data());
        EXPECT_EQ(seen, from_gl);
        sharing.queue.enqueueWriteBuffer(shared, CL_TRUE, 0, 1001, from_cl.data());
        ASSERT_EQ(sharing.release(memory), CL_SUCCESS);
        glGetNamedBufferSubData(buffer, 0, 1001, seen.data());
        EXPECT_EQ(seen, from_cl);
        cl_gl_object_type type = 0;
        EXPECT_EQ(clGetGLObjectInfo(memory(), &type, nullptr), CL_SUCCESS);
        EXPECT_EQ(type, static_cast<cl_gl_object_type>(CL_GL_OBJECT_BUFFER));
        GLint level = 0;
        EXPECT_EQ(clGetGLTextureInfo(memory(), CL_GL_MIPMAP_LEVEL, sizeof(level), &level, nullptr),
                  CL_INVALID_GL_OBJECT);
    }
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(Targets, BuffersThatCannotBeShared) {
    const Sharing sharing(GetParam());
    const auto code_of = [&](GLuint buffer, cl_mem_flags flags = CL_MEM_READ_WRITE) {
        cl_int code = CL_SUCCESS;
        clCreateFromGLBuffer(sharing.context(), flags, buffer, &code);
        return code;
    };
    GLuint without_data = 0;
    glGenBuffers(1, &without_data);
    glBindBuffer(GL_ARRAY_BUFFER, without_data);
    EXPECT_EQ(code_of(0), CL_INVALID_GL_OBJECT);
    EXPECT_EQ(code_of(4711), CL_INVALID_GL_OBJECT);
    EXPECT_EQ(code_of(without_data), CL_INVALID_GL_OBJECT);
    EXPECT_EQ(code_of(make_buffer(Bytes(4)), CL_MEM_USE_HOST_PTR), CL_INVALID_VALUE);
}

TEST_P(Targets, BuffersAreNotAcquiredWhileOpenGLHasThemMapped) {
    const Sharing sharing(GetParam());
    const cl::Memory memory = sharing.share_buffer(make_buffer(Bytes(64)));
    glMapBufferRange(GL_ARRAY_BUFFER, 0, 64, GL_MAP_READ_BIT);
    EXPECT_EQ(sharing.acquire(memory), CL_INVALID_OPERATION);
    glUnmapBuffer(GL_ARRAY_BUFFER);
    EXPECT_EQ(sharing.acquire(memory), CL_SUCCESS);
    glBufferData(GL_ARRAY_BUFFER, 32, nullptr, GL_DYNAMIC_DRAW);
    EXPECT_EQ(sharing.release(memory), CL_INVALID_GL_OBJECT);
}

}  // namespace
}  // namespace stagelight
