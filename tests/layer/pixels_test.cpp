// SPDX-License-Identifier: MIT
// Every format keeps every bit on its way from OpenGL to OpenCL and back.
#include "layer/gl_format_table.h"
#include "layer/sharing.h"

namespace stagelight {
namespace {

using Binding = GlWindow::Binding;

struct Picture {
    GLsizei width;
    GLsizei height;
    GLint level;
};

// Makes the level, and those below it, twice the size from level to level.
GLuint make_levels(const PromisedFormat &format, const Picture &picture, const Bytes &pixels) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (GLint level = 0; level <= picture.level; ++level) {
        const int larger = picture.level - level;
        glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(format.internal),
                     picture.width << larger, picture.height << larger, 0, format.order,
                     format.type, larger == 0 ? pixels.data() : nullptr);
    }
    return texture;
}

// Random bits, but no NaN: OpenGL and OpenCL need not keep which NaN it is.
Bytes random_pixels(const PromisedFormat &format, const Picture &picture, unsigned seed) {
    const auto count = static_cast<std::size_t>(picture.width * picture.height);
    Bytes pixels = random_bytes(count * format.pixel, seed);
    const std::size_t channel = format.type == GL_FLOAT ? 4 : format.type == GL_HALF_FLOAT ? 2 : 0;
    for (std::size_t last = channel - 1; channel > 0 && last < pixels.size(); last += channel) {
        pixels[last] &= 0xBB;  // one bit of the exponent is 0, in float and in half
    }
    return pixels;
}

void expect_round_trip(const Sharing &sharing, const PromisedFormat &format,
                       const Picture &picture) {
    const Bytes from_gl = random_pixels(format, picture, 1);
    const Bytes from_cl = random_pixels(format, picture, 2);
    const GLuint texture = make_levels(format, picture, from_gl);
    const cl::Memory image = sharing.share(texture, GL_TEXTURE_2D, picture.level);
    const std::array<std::size_t, 3> size{static_cast<std::size_t>(picture.width),
                                          static_cast<std::size_t>(picture.height), 1};
    ASSERT_EQ(sharing.acquire(image), CL_SUCCESS);
    EXPECT_EQ(sharing.read_image(image, format.pixel, size), from_gl);
    sharing.write_image(image, from_cl, size);
    ASSERT_EQ(sharing.release(image), CL_SUCCESS);
    Bytes now(from_cl.size());
    glGetTextureImage(texture, picture.level, format.order, format.type,
                      static_cast<GLsizei>(now.size()), now.data());
    EXPECT_EQ(now, from_cl);
    glDeleteTextures(1, &texture);
}

class Pixels : public ::testing::TestWithParam<std::tuple<const char *, Binding>> {};
INSTANTIATE_TEST_SUITE_P(Everywhere, Pixels,
                         ::testing::Combine(::testing::ValuesIn(implementations),
                                            ::testing::Values(Binding::glx, Binding::egl)),
                         [](const auto &tested) {
                             return name_in_tests(std::get<0>(tested.param))
                                    + (std::get<1>(tested.param) == Binding::glx ? "_glx" : "_egl");
                         });

TEST_P(Pixels, KeepEveryBitInEveryFormatTheDeviceHas) {
    const Sharing sharing(std::get<0>(GetParam()), std::get<1>(GetParam()));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    int shared = 0;
    for (const PromisedFormat &format : promised_formats()) {
        SCOPED_TRACE(::testing::Message() << "GL internal format " << std::hex << format.internal);
        if (sharing.supports(format.image)) {
            ++shared;
            for (const Picture &each :
                 {Picture{1, 1, 0}, {7, 5, 0}, {33, 17, 0}, {64, 64, 0}, {1, 1, 1}, {5, 3, 1}}) {
                SCOPED_TRACE(::testing::Message()
                             << each.width << "x" << each.height << ", level " << each.level);
                expect_round_trip(sharing, format, each);
            }
        } else {
            const GLuint texture = make_levels(format, {4, 4, 0}, Bytes(256));
            EXPECT_EQ(sharing.make(texture), (Made{nullptr, CL_INVALID_IMAGE_FORMAT_DESCRIPTOR}));
        }
    }
    EXPECT_GE(shared, 13);  // PoCL 7.1's; PoCL 3.1 has 25, rusticl 21
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(Pixels, TellTheImageWhatTheyAre) {
    const Sharing sharing(std::get<0>(GetParam()), std::get<1>(GetParam()));
    for (const PromisedFormat &format : promised_formats()) {
        if (sharing.supports(format.image)) {
            const GLuint texture = make_levels(format, {7, 5, 0}, Bytes(1000));
            const cl::Image2D image(sharing.share(texture)(), true);
            const auto shown = image.getImageInfo<CL_IMAGE_FORMAT>();
            EXPECT_EQ(shown.image_channel_order, format.image.image_channel_order);
            EXPECT_EQ(shown.image_channel_data_type, format.image.image_channel_data_type);
            EXPECT_EQ(image.getImageInfo<CL_IMAGE_WIDTH>(), 7U);
            EXPECT_EQ(image.getImageInfo<CL_IMAGE_HEIGHT>(), 5U);
        }
    }
}

// Doubles what it reads.
constexpr char doubling[] = R"(
constant sampler_t nearest = CLK_NORMALIZED_COORDS_FALSE | CLK_ADDRESS_CLAMP | CLK_FILTER_NEAREST;
kernel void render(read_only image2d_t from, write_only image2d_t to) {
    int2 at = (int2)(get_global_id(0), get_global_id(1));
    write_imagef(to, at, 2.0f * read_imagef(from, nearest, at));
})";

std::vector<float> float_texture_pixels(GLuint texture, std::size_t count) {
    std::vector<float> pixels(count);
    glGetTextureImage(texture, 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(4 * count),
                      pixels.data());
    return pixels;
}

TEST_P(Pixels, AreReadAndWrittenByAKernel) {
    const Sharing sharing(std::get<0>(GetParam()), std::get<1>(GetParam()));
    std::vector<float> values(4 * 9 * 6);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<float>(i) - 0.25F;
    }
    GLuint textures[2] = {make_texture(1, 1, {}), make_texture(1, 1, {})};
    for (const GLuint texture : textures) {
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 9, 6, 0, GL_RGBA, GL_FLOAT, values.data());
    }
    const cl::Memory from = sharing.share(textures[0]);
    const cl::Memory to = sharing.share(textures[1]);
    cl::Program program(sharing.context, doubling);
    program.build();
    cl::Kernel kernel(program, "render");
    kernel.setArg(0, from);
    kernel.setArg(1, to);
    const std::vector<cl::Memory> both{from, to};
    sharing.queue.enqueueAcquireGLObjects(&both);
    sharing.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(9, 6));
    sharing.queue.enqueueReleaseGLObjects(&both);
    EXPECT_EQ(float_texture_pixels(textures[0], values.size()), values);
    for (float &each : values) {
        each *= 2;
    }
    EXPECT_EQ(float_texture_pixels(textures[1], values.size()), values);
}

}  // namespace
}  // namespace stagelight
