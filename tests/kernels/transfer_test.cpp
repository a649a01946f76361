// SPDX-License-Identifier: MIT
// kernels/transfer_curves.h in each of its languages: C++, GLSL, and OpenCL C on both
// implementations.
#include "transfer_curves.h"

#include <cmath>
#include <limits>
#include <string>

#include "exact_curves.h"
#include "kernels/curves_in_glsl.h"
#include "kernels/on_device.h"
#include "kernels/worst.h"

namespace stagelight {
namespace {

using glm::dvec4, glm::vec4;
using Values = std::vector<float>;

constexpr double unit_of_16_bits = 1.0 / 65535;
constexpr const char *curves[] = {"srgb_encode", "srgb_decode", "power_encode", "power_decode"};

vec4 curves_in_cpp(float value) {
    return {transfer::srgb_encode(value), transfer::srgb_decode(value),
            transfer::power_encode(value), transfer::power_decode(value)};
}

dvec4 exact_curves(double value) {
    return {exact::srgb_encode(value), exact::srgb_decode(value), exact::power_encode(value),
            exact::power_decode(value)};
}

class KernelsStage08Curves : public testing::TestWithParam<const char *> {
protected:
    static std::vector<vec4> run(const Values &values) {
        const std::string language = GetParam();
        if (language == "cpp") {
            std::vector<vec4> results(values.size());
            std::ranges::transform(values, results.begin(), curves_in_cpp);
            return results;
        }
        return language == "glsl" ? curves_in_glsl(values)
                                  : DeviceProgram(choose_device(language), "transfer.cl", {}, {})
                                        .run<vec4>("curves", values);
    }
};
INSTANTIATE_TEST_SUITE_P(In, KernelsStage08Curves, testing::ValuesIn([] {
                             std::vector<const char *> languages{"cpp", "glsl"};
                             languages.insert(languages.end(), implementations.begin(),
                                              implementations.end());
                             return languages;
                         }()),
                         device_name);

// Evenly, down through all powers of ten, and step by step across sRGB's two corners.
Values sweep() {
    Values values;
    constexpr int even = 1 << 18;
    for (int i = 0; i <= even; ++i) {
        values.push_back(float(i) / even);
    }
    for (double value = 1; value > 1e-37; value *= 0.99) {
        values.push_back(float(value));
    }
    for (const float corner : {0.0031308F, 0.04045F}) {
        float above = corner, below = corner;
        for (int i = 0; i < 64; ++i) {
            values.insert(values.end(), {above, below});
            above = std::nextafter(above, 1.0F);
            below = std::nextafter(below, 0.0F);
        }
    }
    return values;
}

TEST_P(KernelsStage08Curves, AreExactTo16Bits) {
    const Values values = sweep();
    const std::vector<vec4> results = run(values);
    for (int curve = 0; curve < 4; ++curve) {
        Worst worst(curves[curve]);
        for (std::size_t i = 0; i < values.size(); ++i) {
            worst.compare(i, double(results[i][curve]), exact_curves(double(values[i]))[curve],
                          unit_of_16_bits);
        }
        worst.expect(270000);
    }
}

// Decoded, encoded, and rounded to the nearest code.
TEST_P(KernelsStage08Curves, BringAll256CodesBack) {
    Values codes, srgb, power;
    for (int code = 0; code < 256; ++code) {
        codes.push_back(float(code) / 255);
    }
    for (const vec4 &decoded : run(codes)) {
        srgb.push_back(decoded[1]);
        power.push_back(decoded[3]);
    }
    const std::vector<vec4> from_srgb = run(srgb), from_power = run(power);
    for (std::size_t code = 0; code < 256; ++code) {
        EXPECT_EQ(std::floor(from_srgb[code][0] * 255 + 0.5F), float(code)) << "sRGB";
        EXPECT_EQ(std::floor(from_power[code][2] * 255 + 0.5F), float(code)) << "power";
    }
}

// What no screen shows: not a number and negatives are 0, and not -0; what is above 1 is as 1.
TEST_P(KernelsStage08Curves, EndWhereAScreenDoes) {
    using Limits = std::numeric_limits<float>;
    const Values dark{0,     -0.0F,          Limits::quiet_NaN(),  -Limits::quiet_NaN(),
                      -1,    -1e-9F,         -Limits::max(),       -Limits::infinity(),
                      -0.5F, -Limits::min(), -Limits::denorm_min()};
    for (const vec4 &result : run(dark)) {
        for (int curve = 0; curve < 4; ++curve) {
            EXPECT_EQ(result[curve], 0) << curves[curve];
            EXPECT_FALSE(std::signbit(result[curve])) << curves[curve];
        }
    }
    const Values bright{
        1, std::nextafter(1.0F, 2.0F), 1.5F, 300, Limits::max(), Limits::infinity()};
    for (const vec4 &result : run(bright)) {
        for (int curve = 0; curve < 4; ++curve) {
            EXPECT_NEAR(result[curve], 1, unit_of_16_bits) << curves[curve];
            EXPECT_LE(result[curve], 1) << curves[curve];
        }
    }
}

}  // namespace
}  // namespace stagelight
