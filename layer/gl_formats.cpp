// SPDX-License-Identifier: MIT
#include "gl_formats.h"

#include "refusal.h"

namespace stagelight {
namespace {

// OpenCL Extension Specification, cl_khr_gl_sharing, "List of OpenGL and corresponding OpenCL Image
// Formats".
// clang-format off
constexpr Format formats[] = {
    {GL_RGBA8,        GL_RGBA, GL_UNSIGNED_BYTE,  {CL_RGBA,  CL_UNORM_INT8},  4},
    {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE,  {CL_sRGBA, CL_UNORM_INT8},  4},
    {GL_RGBA8_SNORM,  GL_RGBA, GL_BYTE,           {CL_RGBA,  CL_SNORM_INT8},  4},
    {GL_RGBA16,       GL_RGBA, GL_UNSIGNED_SHORT, {CL_RGBA,  CL_UNORM_INT16}, 8},
    {GL_RGBA16_SNORM, GL_RGBA, GL_SHORT,          {CL_RGBA,  CL_SNORM_INT16}, 8},
    {GL_RGBA16F,      GL_RGBA, GL_HALF_FLOAT,     {CL_RGBA,  CL_HALF_FLOAT},  8},
    {GL_RGBA32F,      GL_RGBA, GL_FLOAT,          {CL_RGBA,  CL_FLOAT},      16},
    {GL_RG8,          GL_RG,   GL_UNSIGNED_BYTE,  {CL_RG,    CL_UNORM_INT8},  2},
    {GL_RG8_SNORM,    GL_RG,   GL_BYTE,           {CL_RG,    CL_SNORM_INT8},  2},
    {GL_RG16,         GL_RG,   GL_UNSIGNED_SHORT, {CL_RG,    CL_UNORM_INT16}, 4},
    {GL_RG16_SNORM,   GL_RG,   GL_SHORT,          {CL_RG,    CL_SNORM_INT16}, 4},
    {GL_RG16F,        GL_RG,   GL_HALF_FLOAT,     {CL_RG,    CL_HALF_FLOAT},  4},
    {GL_RG32F,        GL_RG,   GL_FLOAT,          {CL_RG,    CL_FLOAT},       8},
    {GL_R8,           GL_RED,  GL_UNSIGNED_BYTE,  {CL_R,     CL_UNORM_INT8},  1},
    {GL_R8_SNORM,     GL_RED,  GL_BYTE,           {CL_R,     CL_SNORM_INT8},  1},
    {GL_R16,          GL_RED,  GL_UNSIGNED_SHORT, {CL_R,     CL_UNORM_INT16}, 2},
    {GL_R16_SNORM,    GL_RED,  GL_SHORT,          {CL_R,     CL_SNORM_INT16}, 2},
    {GL_R16F,         GL_RED,  GL_HALF_FLOAT,     {CL_R,     CL_HALF_FLOAT},  2},
    {GL_R32F,         GL_RED,  GL_FLOAT,          {CL_R,     CL_FLOAT},       4},

    {GL_RGBA8I,   GL_RGBA_INTEGER, GL_BYTE,           {CL_RGBA, CL_SIGNED_INT8},     4},
    {GL_RGBA16I,  GL_RGBA_INTEGER, GL_SHORT,          {CL_RGBA, CL_SIGNED_INT16},    8},
    {GL_RGBA32I,  GL_RGBA_INTEGER, GL_INT,            {CL_RGBA, CL_SIGNED_INT32},   16},
    {GL_RGBA8UI,  GL_RGBA_INTEGER, GL_UNSIGNED_BYTE,  {CL_RGBA, CL_UNSIGNED_INT8},   4},
    {GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT, {CL_RGBA, CL_UNSIGNED_INT16},  8},
    {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT,   {CL_RGBA, CL_UNSIGNED_INT32}, 16},
    {GL_RG8I,     GL_RG_INTEGER,   GL_BYTE,           {CL_RG,   CL_SIGNED_INT8},     2},
    {GL_RG16I,    GL_RG_INTEGER,   GL_SHORT,          {CL_RG,   CL_SIGNED_INT16},    4},
    {GL_RG32I,    GL_RG_INTEGER,   GL_INT,            {CL_RG,   CL_SIGNED_INT32},    8},
    {GL_RG8UI,    GL_RG_INTEGER,   GL_UNSIGNED_BYTE,  {CL_RG,   CL_UNSIGNED_INT8},   2},
    {GL_RG16UI,   GL_RG_INTEGER,   GL_UNSIGNED_SHORT, {CL_RG,   CL_UNSIGNED_INT16},  4},
    {GL_RG32UI,   GL_RG_INTEGER,   GL_UNSIGNED_INT,   {CL_RG,   CL_UNSIGNED_INT32},  8},
    {GL_R8I,      GL_RED_INTEGER,  GL_BYTE,           {CL_R,    CL_SIGNED_INT8},     1},
    {GL_R16I,     GL_RED_INTEGER,  GL_SHORT,          {CL_R,    CL_SIGNED_INT16},    2},
    {GL_R32I,     GL_RED_INTEGER,  GL_INT,            {CL_R,    CL_SIGNED_INT32},    4},
    {GL_R8UI,     GL_RED_INTEGER,  GL_UNSIGNED_BYTE,  {CL_R,    CL_UNSIGNED_INT8},   1},
    {GL_R16UI,    GL_RED_INTEGER,  GL_UNSIGNED_SHORT, {CL_R,    CL_UNSIGNED_INT16},  2},
    {GL_R32UI,    GL_RED_INTEGER,  GL_UNSIGNED_INT,   {CL_R,    CL_UNSIGNED_INT32},  4},
};
// clang-format on

}  // namespace

const Format &format_of(GLenum internal) {
    for (const Format &each : formats) {
        if (each.internal == internal) {
            return each;
        }
    }
    refuse(CL_INVALID_IMAGE_FORMAT_DESCRIPTOR,
           "no OpenCL image format stands for the GL internal format %#06x", internal);
}

}  // namespace stagelight
