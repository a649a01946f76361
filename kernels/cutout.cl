// SPDX-License-Identifier: MIT
// Introduced by stage 06: leaves and fences, cut out of their triangles by the alpha of a picture.
#include "triangle.cl"
#include "wrap.cl"

// #region alpha_at
// Beyond an edge, by less than a texel.
static int edge_texel(const int texel, const int size, const uchar wrap_type) {
    return wrap_type == WRAP_REPEAT ? (texel + size) % size : clamp(texel, 0, size - 1);
}

// The mean of four texels, as filtering/hand.cl has it, from 0 to 255. An image can't be a member of the
// scene; a buffer can, and every ray finds it there.
static float alpha_at(__global const uchar *alphas, const Material *material, const float2 coordinates) {
    const int2 size = convert_int2(material->texture_size);
    const float2 place = wrap(material, coordinates) * XY(material->texture_size) - 0.5f;
    const float2 low = floor(place);
    const float2 share = place - low;
    const int column = edge_texel(convert_int(low.x), size.x, material->wrap_u);
    const int next = edge_texel(convert_int(low.x) + 1, size.x, material->wrap_u);
    __global const uchar *row = &alphas[size.x * edge_texel(convert_int(low.y), size.y, material->wrap_v)];
    __global const uchar *below = &alphas[size.x * edge_texel(convert_int(low.y) + 1, size.y, material->wrap_v)];
    return mix(mix(TO_REAL(row[column]), TO_REAL(row[next]), share.x),
               mix(TO_REAL(below[column]), TO_REAL(below[next]), share.x), share.y);
}
// #endregion alpha_at

// #region is_cut_out
// Whether the triangle is not there, at a place that a ray would hit.
static bool is_cut_out(const Scene *scene, const int index, const float2 barycentric) {
    const Triangle triangle = scene->triangles[index];
    const Cutout cutout = scene->cutouts[triangle.material];
    if (cutout.cutoff == 0.0f) {
        return false;
    }
    const Material material = scene->materials[triangle.material];
    const float2 coordinates = blended_coordinates(scene, triangle, barycentric);
    return alpha_at(&scene->alphas[cutout.first], &material, coordinates) < cutout.cutoff;
}

static bool is_cut_out_on_line(const Scene *scene, const int index, const Line line) {
    const Ray along = {line.origin, line.destination - line.origin};
    float2 barycentric;
    intersect_ray_triangle(along, triangle_edges(scene, index), &barycentric);
    return is_cut_out(scene, index, barycentric);
}
// #endregion is_cut_out
