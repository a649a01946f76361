// SPDX-License-Identifier: MIT
#include "scene/texture_set.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <iterator>
#include <ostream>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "scene/messages.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

const SourceLocation here{"scene.toml", 7, 11};
const fs::path scenes = STAGELIGHT_SOURCE_DIR "/scenes";

using Texel = std::array<int, 4>;
using Bytes = std::vector<std::uint8_t>;
using Attributes = std::vector<std::pair<const char *, const char *>>;  // of OpenImageIO

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

std::string big_endian(std::uint32_t value) {
    return {static_cast<char>(value >> 24), static_cast<char>(value >> 16),
            static_cast<char>(value >> 8), static_cast<char>(value)};
}

constexpr int ramps_width = 20;
constexpr int ramps_height = 10;

// Red to the right and green down, with runs of two texels.
Texel ramps(int x, int y) {
    return {24 * (x / 2), 25 * y, 77, 255};
}

Bytes rgb_of_ramps() {
    Bytes rgb;
    for (int y = 0; y < ramps_height; ++y) {
        for (int x = 0; x < ramps_width; ++x) {
            const Texel texel = ramps(x, y);
            std::copy_n(texel.begin(), 3, std::back_inserter(rgb));
        }
    }
    return rgb;
}

// The ramps, in the format that goes by the file's name.
void write_ramps(const fs::path &file, const Attributes &attributes = {}) {
    OIIO::ImageSpec spec(ramps_width, ramps_height, 3, OIIO::TypeDesc::UINT8);
    for (const auto &[name, value] : attributes) {
        spec.attribute(name, value);
    }
    const auto out = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(out && out->open(file.string(), spec)
                && out->write_image(OIIO::TypeDesc::UINT8, rgb_of_ramps().data()) && out->close())
        << OIIO::geterror();
}

struct Format {
    const char *name;
    Attributes attributes = {};
    int tolerance = 0;
};

void PrintTo(const Format &format, std::ostream *out) {
    *out << format.name;
}

// Where its texels end: its footer of 26 bytes starts with where the areas after them do.
std::size_t end_of_tga(const std::string &tga) {
    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned char>(tga[tga.size() - 26 + i]);
    };
    return byte(0) + 256U * byte(1);
}

class TextureFormat : public testing::TestWithParam<Format> {
protected:
    fs::path write() const {
        fs::path file = folder.path() / GetParam().name;
        write_ramps(file, GetParam().attributes);
        return file;
    }

    TemporaryFolder folder;
};

TEST_P(TextureFormat, HasRedRightAndGreenDown) {
    const Texture texture = loaded(write());
    ASSERT_EQ(texture.width, ramps_width);
    ASSERT_EQ(texture.height, ramps_height);
    ASSERT_EQ(texture.texels.size(), 800U);
    for (const auto &[x, y] :
         {std::pair(0, 0), std::pair(19, 0), std::pair(0, 9), std::pair(7, 4)}) {
        const Texel expected = ramps(x, y);
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_NEAR(texel(texture, x, y)[c], expected[c], GetParam().tolerance)
                << "channel " << c << " at " << x << ", " << y;
        }
    }
}

TEST_P(TextureFormat, IsRefusedWhereverItIsCutShort) {
    const std::string whole = bytes_of(write());
    const std::size_t end =
        std::string(GetParam().name).ends_with(".tga") ? end_of_tga(whole) : whole.size();
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

std::vector<Format> formats() {
    std::vector<Format> formats{
        {"a.png"},
        {"a.jpg", {{"compression", "jpeg:100"}, {"jpeg:subsampling", "4:4:4"}}, 6},
        {"a.bmp"},
        {"a.tga"},
        {"runs.tga", {{"compression", "rle"}}},
        {"a.ppm"}};
    if (STAGELIGHT_FREEIMAGE) {
        formats.push_back({"a.webp", {{"compression", "webp:100"}}, 12});
    }
    return formats;
}

INSTANTIATE_TEST_SUITE_P(TextureSet, TextureFormat, testing::ValuesIn(formats()));

// PNG specification, section 5.3: length, type, data, check sum of the last two.
std::string png_chunk(const std::string &type, const std::string &data) {
    const std::string checked = type + data;
    const auto *bytes = reinterpret_cast<const Bytef *>(checked.data());
    return big_endian(static_cast<std::uint32_t>(data.size())) + checked
           + big_endian(static_cast<std::uint32_t>(crc32(0, bytes, uInt(checked.size()))));
}

constexpr std::size_t png_signature = 8;
constexpr std::size_t png_header = 25;  // with length, type and check sum

struct Png {
    const char *name;
    int bits;
    int color_type;
    std::function<std::vector<int>(int x, int y)> values;  // of the channels
    std::array<Texel, 3> expected;                         // at (0, 0), (19, 0) and (0, 9)
    bool is_interlaced = false;
    std::string palette = {};
};

// Row by row, each from a whole byte on, with the filter 0 before it.
std::string rows_of(const Png &png, int first_x, int first_y, int step_x, int step_y) {
    std::string rows;
    for (int y = first_y; y < ramps_height && first_x < ramps_width; y += step_y) {
        rows += '\0';
        unsigned bits = 0;
        int count = 0;
        for (int x = first_x; x < ramps_width; x += step_x) {
            for (const int value : png.values(x, y)) {
                bits = bits << png.bits | static_cast<unsigned>(value);
                for (count += png.bits; count >= 8; count -= 8) {
                    rows += static_cast<char>(bits >> (count - 8));
                }
            }
        }
        if (count > 0) {
            rows += static_cast<char>(bits << (8 - count));
        }
    }
    return rows;
}

std::string bytes_of(const Png &png) {
    std::string rows;
    if (png.is_interlaced) {  // section 8.2
        for (const auto &[x, y, step_x, step_y] : {std::array{0, 0, 8, 8},
                                                   {4, 0, 8, 8},
                                                   {0, 4, 4, 8},
                                                   {2, 0, 4, 4},
                                                   {0, 2, 2, 4},
                                                   {1, 0, 2, 2},
                                                   {0, 1, 1, 2}}) {
            rows += rows_of(png, x, y, step_x, step_y);
        }
    } else {
        rows = rows_of(png, 0, 0, 1, 1);
    }
    uLongf size = compressBound(rows.size());
    std::string data(size, '\0');
    compress(reinterpret_cast<Bytef *>(data.data()), &size,
             reinterpret_cast<const Bytef *>(rows.data()), rows.size());
    data.resize(size);
    return "\x89PNG\r\n\x1a\n"
           + png_chunk("IHDR", big_endian(ramps_width) + big_endian(ramps_height)
                                   + std::string{char(png.bits), char(png.color_type), 0, 0,
                                                 char(png.is_interlaced)})
           + (png.palette.empty() ? "" : png_chunk("PLTE", png.palette)) + png_chunk("IDAT", data)
           + png_chunk("IEND", "");
}

TEST(TextureSet, ReadsEveryKindOfPng) {
    const auto grey = [](int value) { return Texel{value, value, value, 255}; };
    const std::array greys{grey(3), grey(22), grey(228)};
    const std::array colors{ramps(0, 0), ramps(19, 0), ramps(0, 9)};
    const auto grey_value = [](int x, int y) { return 3 + x + 25 * y; };
    const auto rgb = [](int x, int y) {
        const Texel t = ramps(x, y);
        return std::vector{t[0], t[1], t[2]};
    };
    // The lower 8 bits of 16 are dropped, not rounded.
    const auto rgb16 = [](int x, int y) {
        const Texel t = ramps(x, y);
        return std::vector{t[0] * 256 + 255, t[1] * 256 + 128, t[2] * 256};
    };
    const std::vector<Png> kinds{
        {"grey", 8, 0, [&](int x, int y) { return std::vector{grey_value(x, y)}; }, greys},
        {"grey of 1 bit",
         1,
         0,
         [](int x, int y) { return std::vector{int(x > 0 || y > 0)}; },
         {grey(0), grey(255), grey(255)}},
        {"grey of 4 bits",
         4,
         0,
         [](int x, int y) {
             return std::vector{x > 0 ? 7 : y > 0 ? 15 : 1};
         },
         {grey(17), grey(119), grey(255)}},
        {"grey of 16 bits", 16, 0,
         [&](int x, int y) { return std::vector{grey_value(x, y) * 256 + 255}; }, greys},
        {"grey and alpha",
         8,
         4,
         [&](int x, int y) {
             return std::vector{grey_value(x, y), 255 - y};
         },
         {greys[0], greys[1], Texel{228, 228, 228, 246}}},
        {"colors", 8, 2, rgb, colors},
        {"colors, interlaced", 8, 2, rgb, colors, true},
        {"colors of 16 bits", 16, 2, rgb16, colors},
        {"colors and alpha",
         8,
         6,
         [&](int x, int y) {
             std::vector<int> values = rgb(x, y);
             values.push_back(128 + x);
             return values;
         },
         {Texel{0, 0, 77, 128}, Texel{216, 0, 77, 147}, Texel{0, 225, 77, 128}}},
        {"colors and alpha of 16 bits",
         16,
         6,
         [&](int x, int y) {
             std::vector<int> values = rgb16(x, y);
             values.push_back(128 * 256 + 255 + 256 * x);
             return values;
         },
         {Texel{0, 0, 77, 128}, Texel{216, 0, 77, 147}, Texel{0, 225, 77, 128}}},
        {"palette",
         2,
         3,
         [](int x, int y) {
             return std::vector{x > 0 ? 1 : y > 0 ? 2 : 0};
         },
         {Texel{10, 20, 30, 255}, Texel{40, 50, 60, 255}, Texel{70, 80, 90, 255}},
         false,
         "\x0a\x14\x1e\x28\x32\x3c\x46\x50\x5a"}};
    const TemporaryFolder folder;
    for (const Png &png : kinds) {
        SCOPED_TRACE(png.name);
        const Texture texture = loaded(folder.write(png.name, bytes_of(png)));
        EXPECT_EQ(texel(texture, 0, 0), png.expected[0]);
        EXPECT_EQ(texel(texture, 19, 0), png.expected[1]);
        EXPECT_EQ(texel(texture, 0, 9), png.expected[2]);
    }
}

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

// Wrapped another way it is another texture, of the same texels, which are not read again.
TEST(TextureSet, KeepsAPictureOnceForEachWayToWrapIt) {
    std::vector<Texture> textures;
    int reads = 0;
    const auto index = [&](Wraps wraps) {
        const auto read = [&] {
            ++reads;
            return Texture{
                .file = "a", .width = 1, .height = 1, .texels = {1, 2, 3, 4}, .where = here};
        };
        return texture_once(textures, "a", read, wraps);
    };
    EXPECT_EQ(index({}), 0);
    EXPECT_EQ(index({Wrap::clamp, Wrap::mirror}), 1);
    EXPECT_EQ(index({Wrap::mirror, Wrap::clamp}), 2);
    EXPECT_EQ(index({Wrap::clamp, Wrap::mirror}), 1);
    EXPECT_EQ(index({}), 0);
    EXPECT_EQ(reads, 1);
    EXPECT_EQ(textures.at(1).wrap_v, Wrap::mirror);
    EXPECT_EQ(textures.at(2).texels, textures.at(0).texels);
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
    write_ramps(file);
    expect_refusal(file, "not a picture that can be read");
}

TEST(TextureSet, NamesWhatOnlyFreeImageReads) {
    const TemporaryFolder folder;
    const fs::path webp = folder.path() / "a.webp";
    write_ramps(webp);
    const fs::path text = folder.write("a.pgm", "P2 1 1 255 40\n");
    const fs::path large = folder.write("b.pgm", "P5 # the\n 1\n# size\n1 15\n\3");
    if (STAGELIGHT_FREEIMAGE) {
        EXPECT_EQ(loaded(webp).width, ramps_width);
        EXPECT_EQ(texel(loaded(text), 0, 0), (Texel{40, 40, 40, 255}));
        EXPECT_EQ(texel(loaded(large), 0, 0), (Texel{51, 51, 51, 255}));
    } else {
        for (const auto &[file, format] : {std::pair(webp, "WebP"),
                                           {text, "PGM as text"},
                                           {large, "PNM whose largest value is not 255"}}) {
            std::vector<Texture> textures;
            EXPECT_EQ(message_of([&, &picture = file] { load_texture(textures, picture, here); }),
                      fmt::format("scene.toml:7:11: {} can't be read: this build reads no {}: "
                                  "FreeImage is not on this system; convert the picture to PNG",
                                  file.string(), format));
        }
    }
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
