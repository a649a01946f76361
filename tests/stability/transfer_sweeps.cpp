// SPDX-License-Identifier: MIT
// Where a curve between light and a picture's codes is off, in codes of 8 bits. The truth is IEC
// 61966-2-1 in long double.
#include <cmath>

#include "image/transfer.h"
#include "kernels/on_device.h"
#include "stability/sweep.h"

namespace stagelight::stability {
namespace {

using glm::vec4;
using Real = long double;

using StabilityStage08Transfer = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, StabilityStage08Transfer, each_device(), device_name);

long double true_code(long double light) {
    return 255
           * (light <= 0.0031308L ? 12.92L * light : 1.055L * std::pow(light, 1 / 2.4L) - 0.055L);
}

Question question(const char *name, const char *kind, const char *title) {
    return {.name = name,
            .kind = kind,
            .title = title,
            .x_label = "1 / light",
            .y_label = "error in codes of 255",
            .limit = 0.5,  // the next code
            .stated = "light from 1 down to 1e-6"};
}

// As the host does it, in one place; on a device by the same curves (transfer.cl).
TEST_P(StabilityStage08Transfer, CurvesInTheDark) {
    std::vector<double> all_x;
    std::vector<float> light, value;
    for (int power = 0; power <= 96; ++power) {
        all_x.push_back(std::pow(10, power / 16.0));
        light.push_back(float(1 / all_x.back()));
        value.push_back(float(true_code(light.back()) / 255));
    }
    DeviceProgram program = build("transfer.cl");
    const auto of_light = program.run<vec4>("curves", light);
    const auto of_value = program.run<vec4>("curves", value);
    Sweep encoding(question("encode", "encode", "Light to codes in the dark"), GetParam());
    Sweep decoding(question("decode", "decode", "Codes to light in the dark"), GetParam());
    for (std::size_t i = 0; i < light.size(); ++i) {
        const double x = all_x[i];
        const auto add = [x](Sweep &sweep, const char *method, long double is, long double truth) {
            sweep.add(method, x, double(std::abs(is - truth)));
        };
        const long double code = 255 * Real(value[i]);
        for (const float is : {of_light[i].x, encode(Transfer::srgb, light[i])}) {
            add(encoding, "srgb", 255 * is, true_code(light[i]));
        }
        for (const float is : {of_light[i].z, encode(Transfer::power, light[i])}) {
            add(encoding, "2.2", 255 * is, true_code(light[i]));
        }
        add(encoding, "table", 255 * encode(Transfer::table, light[i]), true_code(light[i]));
        for (const float is : {of_value[i].y, decode(Transfer::srgb, value[i])}) {
            add(decoding, "srgb", true_code(is), code);
        }
        for (const float is : {of_value[i].w, decode(Transfer::power, value[i])}) {
            add(decoding, "2.2", true_code(is), code);
        }
    }
    encoding.expect_holds("srgb", 1e6);
    encoding.expect_holds("table", 1e6);
    decoding.expect_holds("srgb", 1e6);
    encoding.expect_fails("2.2", 10);
    decoding.expect_fails("2.2", 10);
}

}  // namespace
}  // namespace stagelight::stability
