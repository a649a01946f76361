// SPDX-License-Identifier: MIT
// Which textures clCreateFromGLTexture and its elders refuse, and how.
#include "layer/sharing.h"

namespace stagelight {
namespace {

using Creation = OnEach;
STAGELIGHT_ON_EACH(Creation);

Made refused(cl_int code) {
    return {nullptr, code};
}

TEST_P(Creation, NeedsATexture) {
    const Sharing sharing(GetParam());
    const GLuint texture = make_texture(4, 4, {});
    EXPECT_EQ(sharing.make(0), refused(CL_INVALID_GL_OBJECT));
    EXPECT_EQ(sharing.make(4711), refused(CL_INVALID_GL_OBJECT));
    EXPECT_EQ(sharing.make(texture, GL_TEXTURE_3D), refused(CL_INVALID_GL_OBJECT));
    EXPECT_EQ(sharing.make(texture, GL_TEXTURE_CUBE_MAP_POSITIVE_X), refused(CL_INVALID_GL_OBJECT));
    glDeleteTextures(1, &texture);
    EXPECT_EQ(sharing.make(texture), refused(CL_INVALID_GL_OBJECT));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(Creation, KnowsItsTargetsAndFlags) {
    const Sharing sharing(GetParam());
    const GLuint texture = make_texture(4, 4, {});
    for (const auto target :
         std::initializer_list<GLenum>{GL_TEXTURE_CUBE_MAP, GL_TEXTURE_2D_MULTISAMPLE, GL_NONE}) {
        EXPECT_EQ(sharing.make(texture, target), refused(CL_INVALID_VALUE));
    }
    EXPECT_EQ(sharing.make(texture, GL_TEXTURE_BUFFER), refused(CL_INVALID_OPERATION));
    for (const auto flags : std::initializer_list<cl_mem_flags>{
             CL_MEM_USE_HOST_PTR, CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR}) {
        EXPECT_EQ(sharing.make(texture, GL_TEXTURE_2D, 0, flags), refused(CL_INVALID_VALUE));
    }
    for (const auto flags : std::initializer_list<cl_mem_flags>{CL_MEM_READ_ONLY, CL_MEM_WRITE_ONLY,
                                                                CL_MEM_READ_WRITE, 0}) {
        const auto [made, code] = sharing.make(texture, GL_TEXTURE_2D, 0, flags);
        EXPECT_EQ(code, CL_SUCCESS);
        clReleaseMemObject(made);
    }
}

TEST_P(Creation, KnowsTheMipmapLevels) {
    const Sharing sharing(GetParam());
    const GLuint texture = make_texture(8, 4, {});  // levels 0 to 3
    EXPECT_EQ(sharing.make(texture, GL_TEXTURE_2D, -1), refused(CL_INVALID_MIP_LEVEL));
    EXPECT_EQ(sharing.make(texture, GL_TEXTURE_2D, 4), refused(CL_INVALID_MIP_LEVEL));
    EXPECT_EQ(sharing.make(texture, GL_TEXTURE_2D, 3), refused(CL_INVALID_GL_OBJECT));
    glGenerateMipmap(GL_TEXTURE_2D);
    const cl::Memory last = sharing.share(texture, GL_TEXTURE_2D, 3);
    GLint level = 0;
    EXPECT_EQ(clGetGLTextureInfo(last(), CL_GL_MIPMAP_LEVEL, sizeof(level), &level, nullptr),
              CL_SUCCESS);
    EXPECT_EQ(level, 3);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);
    EXPECT_EQ(sharing.make(texture, GL_TEXTURE_2D, 2), refused(CL_INVALID_MIP_LEVEL));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
    EXPECT_EQ(sharing.make(texture, GL_TEXTURE_2D, 0), refused(CL_INVALID_MIP_LEVEL));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(Creation, NeedsACompleteTexture) {
    const Sharing sharing(GetParam());
    const GLuint texture = make_texture(4, 4, {});
    // OpenGL's default: the commonest mistake of those who begin.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
    EXPECT_EQ(sharing.make(texture), refused(CL_INVALID_GL_OBJECT));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    sharing.share(texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1000);
    glGenerateMipmap(GL_TEXTURE_2D);
    sharing.share(texture);
    glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 3, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(sharing.make(texture), refused(CL_INVALID_GL_OBJECT));
    // Of integers, with filters that only suit others.
    const GLuint integers = make_texture(1, 1, {});
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8UI, 4, 4, 0, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, nullptr);
    sharing.share(integers);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    EXPECT_EQ(sharing.make(integers), refused(CL_INVALID_GL_OBJECT));
    GLuint empty = 0;
    glGenTextures(1, &empty);
    glBindTexture(GL_TEXTURE_2D, empty);
    EXPECT_EQ(sharing.make(empty), refused(CL_INVALID_GL_OBJECT));
}

TEST_P(Creation, NeedsAllFacesOfACubeMap) {
    const Sharing sharing(GetParam());
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    const GLenum first = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
    for (GLenum face = first; face < first + 6; ++face) {
        EXPECT_EQ(sharing.make(texture, first), refused(CL_INVALID_GL_OBJECT));
        glTexImage2D(face, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    }
    sharing.share(texture, first);
}

TEST_P(Creation, TakesTexturesOfFixedStorage) {
    const Sharing sharing(GetParam());
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4);  // complete with the default filters
    sharing.share(texture);
    EXPECT_EQ(sharing.make(texture, GL_TEXTURE_2D, 1), refused(CL_INVALID_MIP_LEVEL));
}

TEST_P(Creation, RefusesFormatsWithoutAnImageFormat) {
    const Sharing sharing(GetParam());
    for (const GLint internal : {GL_RGB8, GL_RGB10_A2, GL_R11F_G11F_B10F, GL_RGBA4}) {
        const GLuint texture = make_texture(4, 4, {});
        glTexImage2D(GL_TEXTURE_2D, 0, internal, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        EXPECT_EQ(sharing.make(texture), refused(CL_INVALID_IMAGE_FORMAT_DESCRIPTOR));
    }
    const GLuint depth = make_texture(4, 4, {});
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 4, 4, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT, nullptr);
    EXPECT_EQ(sharing.make(depth), refused(CL_INVALID_IMAGE_FORMAT_DESCRIPTOR));
}

TEST_P(Creation, TheElderFunctionsKnowTheirTargets) {
    const Sharing sharing(GetParam());
    const GLuint texture = make_texture(4, 4, {});
    cl_int code = CL_SUCCESS;
    const cl::Memory flat(clCreateFromGLTexture2D(sharing.context(), CL_MEM_READ_WRITE,
                                                  GL_TEXTURE_2D, 0, texture, &code),
                          false);
    EXPECT_EQ(code, CL_SUCCESS);
    EXPECT_EQ(clCreateFromGLTexture2D(sharing.context(), CL_MEM_READ_WRITE, GL_TEXTURE_3D, 0,
                                      texture, &code),
              nullptr);
    EXPECT_EQ(code, CL_INVALID_VALUE);
    EXPECT_EQ(clCreateFromGLTexture3D(sharing.context(), CL_MEM_READ_WRITE, GL_TEXTURE_2D, 0,
                                      texture, &code),
              nullptr);
    EXPECT_EQ(code, CL_INVALID_VALUE);
    GLuint deep = 0;
    glGenTextures(1, &deep);
    glBindTexture(GL_TEXTURE_3D, deep);
    glTexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA8, 4, 3, 2);
    const cl::Memory volume(clCreateFromGLTexture3D(sharing.context(), CL_MEM_READ_WRITE,
                                                    GL_TEXTURE_3D, 0, deep, &code),
                            false);
    EXPECT_EQ(code, CL_SUCCESS);
}

TEST_P(Creation, InfoIsOfSharedObjectsOnly) {
    const Sharing sharing(GetParam());
    const cl::Buffer own(sharing.context, CL_MEM_READ_WRITE, 16);
    GLint level = 0;
    EXPECT_EQ(clGetGLObjectInfo(own(), nullptr, nullptr), CL_INVALID_GL_OBJECT);
    EXPECT_EQ(clGetGLTextureInfo(own(), CL_GL_MIPMAP_LEVEL, sizeof(level), &level, nullptr),
              CL_INVALID_GL_OBJECT);
    EXPECT_EQ(clGetGLObjectInfo(nullptr, nullptr, nullptr), CL_INVALID_MEM_OBJECT);
    const cl::Memory image = sharing.share(make_texture(4, 4, {}));
    EXPECT_EQ(clGetGLTextureInfo(image(), CL_GL_MIPMAP_LEVEL, 1, &level, nullptr),
              CL_INVALID_VALUE);
    EXPECT_EQ(clGetGLTextureInfo(image(), CL_GL_MIPMAP_LEVEL, 0, nullptr, nullptr),
              CL_INVALID_VALUE);
    EXPECT_EQ(clGetGLTextureInfo(image(), 0, sizeof(level), &level, nullptr), CL_INVALID_VALUE);
}

}  // namespace
}  // namespace stagelight
