// SPDX-License-Identifier: MIT
// #stub
// Exercise 08.2: what is brighter than a screen, bent below 1.
// #solution
// Exercise 08.2, solved: Reinhard's curve on the luminance, one factor for all channels.
// #end

// kernels/picture.cl
// #region picture_buffer
#define PICTURE __global Single4 *
#define LUMINANCE (float3)(0.2126f, 0.7152f, 0.0722f)
#define EXPOSURE 4.0f
#define WHITE 6.0f

// #stub
static float3 tone_mapped(const float3 light) {
    return EXPOSURE * light;  // your turn
}
// #solution
// Reinhard, Stark, Shirley and Ferwerda, Photographic Tone Reproduction for Digital Images (SIGGRAPH 2002),
// equation 4, over L.
static float3 tone_mapped(const float3 light) {
    const float3 exposed = EXPOSURE * light;
    const float luminance = dot(exposed, LUMINANCE);
    return (1.0f + luminance / (WHITE * WHITE)) / (1.0f + luminance) * exposed;
}
// #end

static void write_pixel(PICTURE image, const int width, const int2 pixel, const float3 color) {
    image[pixel.y * width + pixel.x] = (float4)(tone_mapped(color), 1.0f);
}
// #endregion picture_buffer
