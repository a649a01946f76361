// SPDX-License-Identifier: MIT
// The layer's table of formats, every row: no driver offers them all, so none is asked.
#include "layer/gl_formats.h"

#include <gtest/gtest.h>

#include "layer/gl_format_table.h"
#include "layer/refusal.h"

namespace stagelight {
namespace {

TEST(GlFormats, AreThoseThatTheSpecificationPromises) {
    for (const PromisedFormat &promised : promised_formats()) {
        if (promised.internal == GL_RGBA) {
            continue;  // not sized: OpenGL chooses, and the layer asks what it chose
        }
        SCOPED_TRACE(testing::Message() << "internal format " << std::hex << promised.internal);
        const Format &format = format_of(promised.internal);
        EXPECT_EQ(format.order, promised.order);
        EXPECT_EQ(format.type, promised.type);
        EXPECT_EQ(format.cl.image_channel_order, promised.image.image_channel_order);
        EXPECT_EQ(format.cl.image_channel_data_type, promised.image.image_channel_data_type);
        EXPECT_EQ(format.pixel, promised.pixel);
        EXPECT_EQ(format.bytes({7, 5, 3}), 7 * 5 * 3 * promised.pixel);
        const bool is_integer = promised.order == GL_RGBA_INTEGER || promised.order == GL_RG_INTEGER
                                || promised.order == GL_RED_INTEGER;
        EXPECT_EQ(format.is_integer(), is_integer);
    }
}

TEST(GlFormats, HaveNoneForDepth) {
    EXPECT_THROW(format_of(GL_DEPTH_COMPONENT24), Refusal);
}

}  // namespace
}  // namespace stagelight
