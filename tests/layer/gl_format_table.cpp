// SPDX-License-Identifier: MIT
#include "layer/gl_format_table.h"

namespace stagelight {
namespace {

struct Type {
    GLenum type;
    cl_channel_type image;
    std::size_t bytes;
    bool integer;
    GLenum internal[3];  // RGBA, RG, R
};

constexpr Type types[] = {
    {GL_UNSIGNED_BYTE, CL_UNORM_INT8, 1, false, {GL_RGBA8, GL_RG8, GL_R8}},
    {GL_UNSIGNED_SHORT, CL_UNORM_INT16, 2, false, {GL_RGBA16, GL_RG16, GL_R16}},
    {GL_BYTE, CL_SNORM_INT8, 1, false, {GL_RGBA8_SNORM, GL_RG8_SNORM, GL_R8_SNORM}},
    {GL_SHORT, CL_SNORM_INT16, 2, false, {GL_RGBA16_SNORM, GL_RG16_SNORM, GL_R16_SNORM}},
    {GL_HALF_FLOAT, CL_HALF_FLOAT, 2, false, {GL_RGBA16F, GL_RG16F, GL_R16F}},
    {GL_FLOAT, CL_FLOAT, 4, false, {GL_RGBA32F, GL_RG32F, GL_R32F}},
    {GL_BYTE, CL_SIGNED_INT8, 1, true, {GL_RGBA8I, GL_RG8I, GL_R8I}},
    {GL_SHORT, CL_SIGNED_INT16, 2, true, {GL_RGBA16I, GL_RG16I, GL_R16I}},
    {GL_INT, CL_SIGNED_INT32, 4, true, {GL_RGBA32I, GL_RG32I, GL_R32I}},
    {GL_UNSIGNED_BYTE, CL_UNSIGNED_INT8, 1, true, {GL_RGBA8UI, GL_RG8UI, GL_R8UI}},
    {GL_UNSIGNED_SHORT, CL_UNSIGNED_INT16, 2, true, {GL_RGBA16UI, GL_RG16UI, GL_R16UI}},
    {GL_UNSIGNED_INT, CL_UNSIGNED_INT32, 4, true, {GL_RGBA32UI, GL_RG32UI, GL_R32UI}},
};
constexpr cl_channel_order image_orders[] = {CL_RGBA, CL_RG, CL_R};
constexpr GLenum orders[] = {GL_RGBA, GL_RG, GL_RED};
constexpr GLenum integer_orders[] = {GL_RGBA_INTEGER, GL_RG_INTEGER, GL_RED_INTEGER};
constexpr std::size_t channels[] = {4, 2, 1};

}  // namespace

std::vector<PromisedFormat> promised_formats() {
    constexpr cl_channel_order srgba = 0x10C1;  // CL_sRGBA, of OpenCL 2.0
    std::vector<PromisedFormat> all{
        {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, {srgba, CL_UNORM_INT8}, 4},
        {GL_RGBA, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, {CL_RGBA, CL_UNORM_INT8}, 4}};
    for (const Type &type : types) {
        for (std::size_t i = 0; i < 3; ++i) {
            all.push_back({type.internal[i], type.integer ? integer_orders[i] : orders[i],
                           type.type, cl::ImageFormat(image_orders[i], type.image),
                           channels[i] * type.bytes});
        }
    }
    return all;
}

}  // namespace stagelight
