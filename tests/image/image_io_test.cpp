// SPDX-License-Identifier: MIT
#include "image/image_io.h"

#include <bit>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "exact_curves.h"
#include "image/fixture.h"

namespace stagelight {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

// The file's own numbers, as they stand in it.
template <typename T>
std::vector<T> read_as(OIIO::TypeDesc type, const Path &file, OIIO::ImageSpec &spec) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) {
        ADD_FAILURE() << OIIO::geterror();
        return {};
    }
    spec = input->spec();
    EXPECT_EQ(spec.format, type) << "expected numbers of type " << type.c_str();
    std::vector<T> values(spec.image_pixels() * std::size_t(spec.nchannels));
    EXPECT_TRUE(input->read_image(0, 0, 0, spec.nchannels, type, values.data()))
        << input->geterror();
    return values;
}

Image row(const std::vector<float> &values) {
    Image image(int(values.size()), 1);
    for (int x = 0; x < image.width; ++x) {
        image.at(x, 0) = glm::vec3(values[std::size_t(x)]);
    }
    return image;
}

class ImageIo : public InFolder {
protected:
    // What a grey pixel of each value becomes in a PNG.
    std::vector<int> bytes_of(const std::vector<float> &values, Transfer encode = Transfer::none) {
        write_image(row(values), folder / "a.png", encode);
        OIIO::ImageSpec spec;
        const auto read = read_as<unsigned char>(OIIO::TypeDesc::UINT8, folder / "a.png", spec);
        std::vector<int> bytes;
        for (std::size_t i = 0; i < read.size(); i += 3) {
            EXPECT_EQ(read[i], read[i + 1]);
            EXPECT_EQ(read[i], read[i + 2]);
            bytes.push_back(read[i]);
        }
        return bytes;
    }
};

TEST_F(ImageIo, PngKeepsEachOf256Steps) {
    std::vector<float> values;
    std::vector<int> expected;
    for (int i = 0; i < 256; ++i) {
        values.push_back(float(i) / 255);
        expected.push_back(i);
    }
    EXPECT_EQ(bytes_of(values), expected);
}

// A little to either side of the middle between two steps.
TEST_F(ImageIo, PngRoundsToTheNearestStep) {
    std::vector<float> values;
    std::vector<int> expected;
    for (int i = 0; i < 255; ++i) {
        values.insert(values.end(), {(float(i) + 0.499F) / 255, (float(i) + 0.501F) / 255});
        expected.insert(expected.end(), {i, i + 1});
    }
    EXPECT_EQ(bytes_of(values), expected);
}

TEST_F(ImageIo, PngClampsAndMakesNanBlack) {
    for (const Transfer encode : {Transfer::none, Transfer::srgb, Transfer::power}) {
        EXPECT_EQ(bytes_of({-0.0F, -1e-9F, -2, -infinity, 1.0001F, 300, 1e38F, infinity, nan, -nan},
                           encode),
                  (std::vector<int>{0, 0, 0, 0, 255, 255, 255, 255, 0, 0}));
    }
}

// Light a little to either side of the middle between two codes becomes the nearer of them.
TEST_F(ImageIo, Stage08PngIsEncodedOnceAndRoundedToTheNearestCode) {
    for (const Transfer encode : {Transfer::srgb, Transfer::power}) {
        const auto light = [encode](double code) {
            return float(encode == Transfer::srgb ? exact::srgb_decode(code / 255)
                                                  : exact::power_decode(code / 255));
        };
        std::vector<float> values;
        std::vector<int> expected;
        for (int i = 0; i < 255; ++i) {
            values.insert(values.end(), {light(i), light(i + 0.499), light(i + 0.501)});
            expected.insert(expected.end(), {i, i, i + 1});
        }
        EXPECT_EQ(bytes_of(values, encode), expected);
    }
}

TEST_F(ImageIo, PngKeepsRowsColumnsAndChannelsApart) {
    Image image(3, 2);
    std::vector<unsigned char> expected;
    for (int i = 0; i < 6; ++i) {
        image.at(i % 3, i / 3) = glm::vec3(10 * i, 10 * i + 1, 10 * i + 2) / 255.0F;
        for (int c = 0; c < 3; ++c) {
            expected.push_back(static_cast<unsigned char>(10 * i + c));
        }
    }
    write_image(image, folder / "a.PNG", Transfer::none);
    OIIO::ImageSpec spec;
    EXPECT_EQ(read_as<unsigned char>(OIIO::TypeDesc::UINT8, folder / "a.PNG", spec), expected);
    EXPECT_EQ(spec.width, 3);
    EXPECT_EQ(spec.height, 2);
    EXPECT_EQ(spec.nchannels, 3);
}

// A viewer that found one would change the values that were written.
TEST_F(ImageIo, PngNamesNoGammaColourSpaceOrTime) {
    write_image(row({0, 0.5F, 1}), folder / "a.png", Transfer::none);
    const std::string bytes = read_bytes(folder / "a.png");
    for (const char *chunk : {"gAMA", "sRGB", "cHRM", "iCCP", "tIME", "tEXt"}) {
        EXPECT_EQ(bytes.find(chunk), std::string::npos) << "expected no chunk " << chunk;
    }
}

// The first four bytes of a chunk, the most significant first.
std::uint32_t number_in_chunk(const std::string &file, const char *chunk) {
    std::uint32_t number = 0;
    for (std::size_t i = file.find(chunk) + 4, end = i + 4; i < end; ++i) {
        number = number << 8 | static_cast<unsigned char>(file.at(i));
    }
    return number;
}

// PNG specification: gAMA has 100000 times the exponent; with sRGB, 45455 stands for it.
TEST_F(ImageIo, Stage08PngNamesItsCurve) {
    write_image(row({0, 0.5F, 1}), folder / "a.png", Transfer::srgb);
    const std::string srgb = read_bytes(folder / "a.png");
    EXPECT_NE(srgb.find("sRGB"), std::string::npos);
    EXPECT_EQ(number_in_chunk(srgb, "gAMA"), 45455U);
    write_image(row({0, 0.5F, 1}), folder / "a.png", Transfer::power);
    const std::string power = read_bytes(folder / "a.png");
    EXPECT_EQ(power.find("sRGB"), std::string::npos);
    EXPECT_NEAR(number_in_chunk(power, "gAMA"), 100000 / 2.2, 1);
}

TEST_F(ImageIo, Stage08ExrStaysLinear) {
    for (const Transfer encode : {Transfer::none, Transfer::srgb, Transfer::power}) {
        write_image(row({0.5F, -1, 3}), folder / "a.exr", encode);
        OIIO::ImageSpec spec;
        const auto values = read_as<float>(OIIO::TypeDesc::FLOAT, folder / "a.exr", spec);
        EXPECT_EQ(values, (std::vector<float>{0.5F, 0.5F, 0.5F, -1, -1, -1, 3, 3, 3}));
    }
}

TEST_F(ImageIo, ExrKeepsEveryBit) {
    const std::vector<float> values = {0,
                                       -0.0F,
                                       1.0F / 3,
                                       1e-45F,
                                       1e-30F,
                                       65504,
                                       70000,
                                       std::numeric_limits<float>::max(),
                                       std::nextafter(1.0F, 2.0F),
                                       infinity,
                                       -infinity,
                                       nan,
                                       -1.5F};
    Image image(int(values.size()), 2);
    std::vector<std::uint32_t> expected;
    for (int i = 0; i < int(image.pixels.size()); ++i) {
        for (int c = 0; c < 3; ++c) {
            const float value = values[std::size_t(i + c) % values.size()];
            image.pixels[std::size_t(i)][c] = value;
            expected.push_back(std::bit_cast<std::uint32_t>(value));
        }
    }
    write_image(image, folder / "a.exr", Transfer::none);
    OIIO::ImageSpec spec;
    std::vector<std::uint32_t> bits;
    for (const float value : read_as<float>(OIIO::TypeDesc::FLOAT, folder / "a.exr", spec)) {
        bits.push_back(std::bit_cast<std::uint32_t>(value));
    }
    EXPECT_EQ(bits, expected);
    EXPECT_EQ(spec.channelnames, (std::vector<std::string>{"R", "G", "B"}));
}

// A date would make a difference from one second to the next: expect none, rather than wait.
TEST_F(ImageIo, TheSamePictureIsTheSameFile) {
    for (const std::string extension : {".png", ".exr"}) {
        const Path a = folder / ("a" + extension), b = folder / ("b" + extension);
        write_image(row({0, 0.5F, 1}), a, Transfer::none);
        write_image(row({0, 0.5F, 1}), b, Transfer::none);
        EXPECT_EQ(read_bytes(a), read_bytes(b)) << extension;
        EXPECT_EQ(read_bytes(a).find(":2"), std::string::npos) << "expected no date";
    }
    OIIO::ImageSpec spec;
    read_as<float>(OIIO::TypeDesc::FLOAT, folder / "a.exr", spec);
    EXPECT_EQ(spec.get_string_attribute("DateTime"), "") << "expected no date";
}

TEST_F(ImageIo, ThreadsWriteBesideEachOther) {
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i) {
        threads.emplace_back([&, i] {
            write_image(row({float(i) / 255}), folder / (std::to_string(i) + ".png"),
                        Transfer::none);
        });
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
    EXPECT_EQ(files(), 8);
}

TEST_F(ImageIo, OnlyPngAndExr) {
    for (const char *name : {"a.jpg", "a", "a.png.txt", "a.exrs", ".png", "png"}) {
        const Path file = folder / name;
        const std::string expected = file.string() + ": expected a name that ends in .png or .exr";
        expect_user_error([&] { require_writable(file); }, expected);
        expect_user_error([&] { write_image(Image(1, 1), file, Transfer::none); }, expected);
    }
    expect_user_error([&] { require_writable(folder / ""); }, "expected a name that ends");
    EXPECT_EQ(files(), 0) << "a file was left behind";
    for (const char *name : {"a.png", "a.EXR", "a.b.Png"}) {
        EXPECT_NO_THROW(require_writable(folder / name)) << name;
    }
}

}  // namespace
}  // namespace stagelight
