// SPDX-License-Identifier: MIT
#include "scene/texture_set.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <memory>
#include <ostream>

#include <FreeImage.h>
#include <gtest/gtest.h>

#include "scene/messages.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

const SourceLocation here{"scene.toml", 7, 11};
const fs::path scenes = STAGELIGHT_SOURCE_DIR "/scenes";

using Texel = std::array<int, 4>;
using Bitmap = std::shared_ptr<FIBITMAP>;

Texture loaded(const fs::path &file) {
    std::vector<Texture> textures;
    EXPECT_EQ(load_texture(textures, file, here), 0);
    return textures.at(0);
}

Texel texel(const Texture &texture, int x, int y) {
    const auto first = texture.texels.begin() + 4 * (y * texture.width + x);
    return {first[0], first[1], first[2], first[3]};
}

std::string bytes_of(const fs::path &file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// A 20 x 10 picture, red to the right and green down, with runs of two texels.
Bitmap ramps() {
    const Bitmap bitmap(FreeImage_Allocate(20, 10, 24), FreeImage_Unload);
    for (unsigned y = 0; y < 10; ++y) {
        for (unsigned x = 0; x < 20; ++x) {
            RGBQUAD color{};
            color.rgbRed = static_cast<BYTE>(24 * (x / 2));
            color.rgbGreen = static_cast<BYTE>(25 * (9 - y));  // row 0 is FreeImage's lowest
            color.rgbBlue = 77;
            FreeImage_SetPixelColor(bitmap.get(), x, y, &color);
        }
    }
    return bitmap;
}

Bitmap converted(FIBITMAP *(*convert)(FIBITMAP *)) {
    return {convert(ramps().get()), FreeImage_Unload};
}

struct Format {
    FREE_IMAGE_FORMAT format;
    int flags;
    const char *name;
    int tolerance = 0;
};

void PrintTo(const Format &format, std::ostream *out) {
    *out << format.name;
}

class TextureFormat : public testing::TestWithParam<Format> {
protected:
    fs::path write() const {
        fs::path file = folder.path() / GetParam().name;
        EXPECT_TRUE(
            FreeImage_Save(GetParam().format, ramps().get(), file.c_str(), GetParam().flags));
        return file;
    }

    TemporaryFolder folder;
};

TEST_P(TextureFormat, HasRedRightAndGreenDown) {
    const Texture texture = loaded(write());
    ASSERT_EQ(texture.width, 20);
    ASSERT_EQ(texture.height, 10);
    ASSERT_EQ(texture.texels.size(), 800U);
    for (const auto &[x, y] :
         {std::pair(0, 0), std::pair(19, 0), std::pair(0, 9), std::pair(7, 4)}) {
        const Texel expected{24 * (x / 2), 25 * y, 77, 255};
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_NEAR(texel(texture, x, y)[c], expected[c], GetParam().tolerance)
                << "channel " << c << " at " << x << ", " << y;
        }
    }
}

TEST_P(TextureFormat, IsRefusedWhereverItIsCutShort) {
    const std::string whole = bytes_of(write());
    // A TGA ends in a footer of 26 bytes that no texel lies in.
    const std::size_t end = whole.size() - (GetParam().format == FIF_TARGA ? 26 : 0);
    for (std::size_t length = 0; length < end; length += length + 20 < end ? 7 : 1) {
        std::vector<Texture> textures;
        const fs::path file = folder.write("cut", whole.substr(0, length));
        const std::string message = message_of([&] { load_texture(textures, file, here); });
        EXPECT_EQ(message.rfind("scene.toml:7:11: ", 0), 0U)
            << length << " of " << whole.size() << " bytes: '" << message << "'";
        EXPECT_NE(message.find("expected"), std::string::npos) << message;
        EXPECT_TRUE(textures.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(
    TextureSet, TextureFormat,
    testing::Values(Format{FIF_PNG, 0, "a.png"}, Format{FIF_PNG, PNG_INTERLACED, "interlaced.png"},
                    Format{FIF_JPEG, JPEG_QUALITYSUPERB | JPEG_SUBSAMPLING_444, "a.jpg", 6},
                    Format{FIF_BMP, 0, "a.bmp"}, Format{FIF_TARGA, 0, "a.tga"},
                    Format{FIF_TARGA, TARGA_SAVE_RLE, "runs.tga"},
                    Format{FIF_WEBP, WEBP_LOSSLESS, "a.webp"}, Format{FIF_PPM, 0, "a.ppm"}));

struct Depth {
    const char *name;
    Bitmap bitmap;
    std::array<Texel, 3> expected;  // at (0, 0), (19, 0) and (0, 9)
};

TEST(TextureSet, ReadsEveryDepthOfPng) {
    const auto grey = [](int value) { return Texel{value, value, value, 255}; };
    // 0.2126 red + 0.7152 green + 0.0722 blue, as FreeImage has it.
    const std::array greys{grey(6), grey(51), grey(166)};
    const std::array colors{Texel{0, 0, 77, 255}, Texel{216, 0, 77, 255}, Texel{0, 225, 77, 255}};
    const auto black_or_white = [](FIBITMAP *bitmap) { return FreeImage_Threshold(bitmap, 50); };
    const Bitmap clear = converted(FreeImage_ConvertTo32Bits);
    RGBQUAD half{77, 0, 0, 128};
    FreeImage_SetPixelColor(clear.get(), 0, 9, &half);
    const std::vector<Depth> depths{
        {"grey", converted(FreeImage_ConvertToGreyscale), greys},
        {"grey16", converted(FreeImage_ConvertToUINT16), greys},
        {"rgb16", converted(FreeImage_ConvertToRGB16), colors},
        {"rgba16", converted(FreeImage_ConvertToRGBA16), colors},
        {"one bit", converted(black_or_white), {grey(0), grey(255), grey(255)}},
        {"alpha", clear, {Texel{0, 0, 77, 128}, colors[1], colors[2]}}};
    const TemporaryFolder folder;
    for (const Depth &depth : depths) {
        SCOPED_TRACE(depth.name);
        const fs::path file = folder.path() / depth.name;
        ASSERT_TRUE(FreeImage_Save(FIF_PNG, depth.bitmap.get(), file.c_str()));
        const Texture texture = loaded(file);
        EXPECT_EQ(texel(texture, 0, 0), depth.expected[0]);
        EXPECT_EQ(texel(texture, 19, 0), depth.expected[1]);
        EXPECT_EQ(texel(texture, 0, 9), depth.expected[2]);
    }
}

TEST(TextureSet, ReadsAPalette) {
    const Bitmap bitmap(FreeImage_Allocate(3, 2, 8), FreeImage_Unload);
    RGBQUAD *palette = FreeImage_GetPalette(bitmap.get());
    palette[5] = {30, 20, 10, 0};
    BYTE index = 5;
    FreeImage_SetPixelIndex(bitmap.get(), 2, 1, &index);
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "palette.png";
    ASSERT_TRUE(FreeImage_Save(FIF_PNG, bitmap.get(), file.c_str()));
    EXPECT_EQ(texel(loaded(file), 2, 0), (Texel{10, 20, 30, 255}));
}

std::string big_endian(std::uint32_t value) {
    return {static_cast<char>(value >> 24), static_cast<char>(value >> 16),
            static_cast<char>(value >> 8), static_cast<char>(value)};
}

// PNG specification, section 5.3: length, type, data, check sum of the last two.
std::string png_chunk(const std::string &type, const std::string &data) {
    std::string checked = type + data;
    const auto *bytes = reinterpret_cast<BYTE *>(checked.data());
    return big_endian(static_cast<std::uint32_t>(data.size())) + checked
           + big_endian(FreeImage_ZLibCRC32(0, const_cast<BYTE *>(bytes),
                                            static_cast<DWORD>(checked.size())));
}

constexpr std::size_t png_signature = 8;
constexpr std::size_t png_header = 25;  // with length, type and check sum

TEST(TextureSet, KeepsTexelsAsTheFileHasThemDespiteItsGamma) {
    std::string png = bytes_of(scenes / "checker.png");
    png.insert(png_signature + png_header, png_chunk("gAMA", big_endian(100000)));
    const TemporaryFolder folder;
    EXPECT_EQ(texel(loaded(folder.write("linear.png", png)), 1, 0), (Texel{38, 92, 140, 255}));
}

TEST(TextureSet, Stage06PicturesAreTheRightWayUp) {
    const Texture checker = loaded(scenes / "checker.png");
    EXPECT_EQ(texel(checker, 0, 0), (Texel{214, 40, 90, 255})) << "the odd one";
    EXPECT_EQ(texel(checker, 7, 7), (Texel{230, 148, 62, 255}));
    EXPECT_EQ(texel(checker, 7, 0), (Texel{38, 92, 140, 255}));
    EXPECT_EQ(texel(checker, 0, 7), (Texel{38, 92, 140, 255}));
    const Texture gradient = loaded(scenes / "gradient.png");
    ASSERT_EQ(gradient.width, 37);
    ASSERT_EQ(gradient.height, 19);
    EXPECT_EQ(texel(gradient, 36, 0), (Texel{255, 0, 0, 255}));
    EXPECT_EQ(texel(gradient, 0, 18), (Texel{0, 255, 255, 255}));
}

TEST(TextureSet, LoadsEachPictureOnce) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "a.png";
    fs::copy(scenes / "checker.png", file);
    fs::create_symlink(file, folder.path() / "link.png");
    std::vector<Texture> textures;
    EXPECT_EQ(load_texture(textures, scenes / "gradient.png", here), 0);
    EXPECT_EQ(load_texture(textures, file, here), 1);
    EXPECT_EQ(load_texture(textures, folder.path() / "./a.png", here), 1);
    EXPECT_EQ(load_texture(textures, folder.path() / "link.png", here), 1);
    EXPECT_EQ(textures.size(), 2U);
}

// One line that says where, which file, what is wrong and what was expected; nothing printed.
void expect_refusal(const fs::path &file, const std::string &reason) {
    std::vector<Texture> textures;
    testing::internal::CaptureStderr();
    const std::string message = message_of([&] { load_texture(textures, file, here); });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(message.rfind("scene.toml:7:11: ", 0), 0U) << message;
    for (const std::string &part : {file.filename().string(), reason, std::string("expected")}) {
        EXPECT_NE(message.find(part), std::string::npos)
            << "expected '" << part << "' in: " << message;
    }
    EXPECT_TRUE(textures.empty());
}

TEST(TextureSet, RefusesWhatIsNoPicture) {
    const TemporaryFolder folder;
    expect_refusal(folder.path() / "none.png", "no file");
    expect_refusal(folder.path(), "no file");
    expect_refusal(folder.write("empty.png", ""), "not a picture");
    expect_refusal(folder.write("text.png", "no picture\n"), "not a picture");
    expect_refusal(folder.write("text.tga", std::string(4000, 'a')), "not a picture");
}

TEST(TextureSet, RefusesPicturesOfFloats) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "a.hdr";
    ASSERT_TRUE(FreeImage_Save(FIF_HDR, converted(FreeImage_ConvertToRGBF).get(), file.c_str()));
    expect_refusal(file, "not a picture that can be read");
}

// A PNG that says it is this large, and has no texels: only a header is to be read.
std::string png_of_size(std::uint32_t width, std::uint32_t height) {
    return bytes_of(scenes / "checker.png").substr(0, png_signature)
           + png_chunk("IHDR",
                       big_endian(width) + big_endian(height) + std::string("\x8\x2\0\0\0", 5))
           + png_chunk("IDAT", "") + png_chunk("IEND", "");
}

TEST(TextureSet, RefusesALargePictureByItsHeader) {
    const TemporaryFolder folder;
    expect_refusal(folder.write("wide.png", png_of_size(16385, 1)), "16385 x 1 texels");
    expect_refusal(folder.write("high.png", png_of_size(1, 16385)), "1 x 16385 texels");
    expect_refusal(folder.write("large.png", png_of_size(16384, 16384)), "16384 x 16384 texels");
}

}  // namespace
}  // namespace stagelight
