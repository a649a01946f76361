// SPDX-License-Identifier: MIT
#include <limits>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "image/fixture.h"
#include "image/golden_file.h"
#include "image/image_io.h"

namespace stagelight {
namespace {

// Numbers that half precision holds exactly.
Golden sample() {
    Golden golden{Image(5, 3), std::vector<std::uint8_t>(15)};
    for (std::size_t i = 0; i < 15; ++i) {
        golden.image.pixels[i] = {float(i) / 16, 100 + float(i), -float(i)};
        golden.edge[i] = i % 4 == 1;
    }
    golden.image.at(4, 2) = {65504, -65504, 0x1p-24F};
    return golden;
}

class GoldenFile : public InFolder {
protected:
    Path file = folder / "a.exr";

    // An EXR of other channels than a golden's, or other values.
    void write_exr(const std::vector<std::string> &channels, const std::vector<float> &values) {
        OIIO::ImageSpec spec(int(values.size() / channels.size()), 1, int(channels.size()),
                             OIIO::TypeDesc::HALF);
        spec.channelnames = channels;
        const auto output = OIIO::ImageOutput::create(file.string());
        ASSERT_TRUE(output->open(file.string(), spec)) << output->geterror();
        ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
        ASSERT_TRUE(output->close());
    }

    void expect_refused(const std::string &expected) {
        expect_user_error([&] { read_golden(file); }, expected);
    }
};

TEST_F(GoldenFile, ComesBackAsItWas) {
    write_golden(sample(), file);
    const Golden golden = read_golden(file);
    EXPECT_EQ(golden.image.width, 5);
    EXPECT_EQ(golden.image.height, 3);
    EXPECT_EQ(golden.image.pixels, sample().image.pixels);
    EXPECT_EQ(golden.edge, sample().edge);
}

TEST_F(GoldenFile, IsHalfPrecisionZippedWithFourChannels) {
    write_golden(sample(), file);
    const auto input = OIIO::ImageInput::open(file.string());
    ASSERT_TRUE(input) << OIIO::geterror();
    EXPECT_EQ(input->spec().format, OIIO::TypeDesc::HALF);
    EXPECT_EQ(input->spec().channelnames, (std::vector<std::string>{"R", "G", "B", "edge"}));
    EXPECT_EQ(input->spec().get_string_attribute("compression"), "zip");
    EXPECT_EQ(input->spec().get_string_attribute("DateTime"), "") << "expected no date";
}

TEST_F(GoldenFile, RoundsToTheNearestHalf) {
    Golden golden = sample();
    golden.image.at(0, 0) = {0.1F, 1 + 0x1.8p-11F, 2049};
    write_golden(golden, file);
    EXPECT_EQ(read_golden(file).image.at(0, 0), glm::vec3(0.0999755859375F, 1 + 0x1p-10F, 2048));
}

TEST_F(GoldenFile, TheSameGoldenIsTheSameFile) {
    write_golden(sample(), file);
    write_golden(sample(), folder / "b.exr");
    EXPECT_EQ(read_bytes(file), read_bytes(folder / "b.exr"));
}

TEST_F(GoldenFile, AValueThatHalfPrecisionCannotHoldIsRefused) {
    for (const float value : {65505.0F, -1e6F, std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::quiet_NaN()}) {
        Golden golden = sample();
        golden.image.at(2, 1).y = value;
        expect_user_error([&] { write_golden(golden, file); }, "pixel (2, 1) is ");
    }
    EXPECT_EQ(files(), 0) << "a file was left behind";
}

TEST_F(GoldenFile, MissingOrNoPicture) {
    expect_refused(file.string());
    write_bytes(file, "");
    expect_refused(file.string());
    write_bytes(file, "not a picture at all");
    expect_refused(file.string());
}

TEST_F(GoldenFile, TruncatedAnywhere) {
    write_golden(sample(), file);
    const std::string whole = read_bytes(file);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        write_bytes(file, whole.substr(0, size));
        expect_refused(file.string());
    }
}

TEST_F(GoldenFile, WrongChannels) {
    write_exr({"R", "G", "B"}, {1, 2, 3});
    expect_refused("expected the channels R, G, B, edge, found R, G, B");
    write_exr({"R", "G", "B", "A"}, {1, 2, 3, 0});
    expect_refused("expected the channels R, G, B, edge, found R, G, B, A");
    write_exr({"R", "G", "B", "A", "edge"}, {1, 2, 3, 1, 0});
    expect_refused("expected the channels R, G, B, edge, found R, G, B, A, edge");
    write_image(Image(1, 1), folder / "a.png", Transfer::none);
    std::filesystem::rename(folder / "a.png", file);
    expect_refused("expected the channels R, G, B, edge, found R, G, B");
}

TEST_F(GoldenFile, ChannelsMayComeInAnyOrder) {
    write_exr({"edge", "B", "G", "R"}, {1, 2, 3, 4});
    const Golden golden = read_golden(file);
    EXPECT_EQ(golden.image.at(0, 0), glm::vec3(4, 3, 2));
    EXPECT_EQ(golden.edge, std::vector<std::uint8_t>{1});
}

TEST_F(GoldenFile, NanOrInfinity) {
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        for (std::size_t channel = 0; channel < 4; ++channel) {
            std::vector<float> values(8, 0.5F);
            values[4 + channel] = value;
            write_exr({"R", "G", "B", "edge"}, values);
            expect_refused("found a NaN or an infinity");
        }
    }
}

}  // namespace
}  // namespace stagelight
