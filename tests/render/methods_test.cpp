// SPDX-License-Identifier: MIT
#include "device/methods.h"

#include <gtest/gtest.h>

namespace stagelight {
namespace {

// None before, in whatever was chosen; then each kind its own, sRGB unless chosen.
TEST(Stage08Methods, DecodeAndEncodeFromThereOn) {
    const Methods decode_chosen{{"decode", "2.2"}}, encode_chosen{{"encode", "2.2"}};
    for (int stage = 1; stage <= 7; ++stage) {
        EXPECT_EQ(decode_of(stage, decode_chosen), Transfer::none) << stage;
        EXPECT_EQ(encode_of(stage, encode_chosen), Transfer::none) << stage;
    }
    for (int stage = 8; stage <= 11; ++stage) {
        EXPECT_EQ(decode_of(stage, {}), Transfer::srgb) << stage;
        EXPECT_EQ(encode_of(stage, {}), Transfer::srgb) << stage;
        EXPECT_EQ(decode_of(stage, decode_chosen), Transfer::power) << stage;
        EXPECT_EQ(encode_of(stage, decode_chosen), Transfer::srgb) << stage;
        EXPECT_EQ(decode_of(stage, encode_chosen), Transfer::srgb) << stage;
        EXPECT_EQ(encode_of(stage, encode_chosen), Transfer::power) << stage;
    }
}

// They are the host's: a kernel is built the same with either.
TEST(Stage08Methods, DefineNothingForKernels) {
    Methods methods;
    for (const char *choice : {"decode=srgb", "decode=2.2", "encode=srgb", "encode=2.2"}) {
        choose_method(methods, choice, 8);
        EXPECT_EQ(options_of(methods), options_of({})) << choice;
    }
}

}  // namespace
}  // namespace stagelight
