// SPDX-License-Identifier: MIT
// The reference: a Whitted tracer in C++, recursive, in a number type of choice, for
// reading beside the paper and for judging the kernels, with which it shares no
// intersection or shading code.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "image/image.h"
#include "image/transfer.h"
#include "scene/scene.h"

namespace stagelight::reference {

// What the light does inside a dielectric sphere.
enum class Interior {
    full,   // every inner reflection, up to the depth limit
    paper,  // the paper's single pass: in, absorbed, out
};

// What share of the light a dielectric reflects.
enum class Fresnel { schlick, exact };

// Where light ends on a mesh whose normals are smooth.
enum class Terminator {
    none,    // as its facets are lit, and shadow each other
    chiang,  // light fades out before a facet turns away
    hanika,  // shadow rays start on the smooth surface
};

struct Settings {
    int width = 320;
    int height = 192;
    int max_depth = 8;
    Interior interior = Interior::full;
    Fresnel fresnel = Fresnel::schlick;
    Terminator terminator = Terminator::none;
    Transfer decode = Transfer::none;  // which curve takes texels to light
};

struct Result {
    Image image;
    std::vector<std::uint8_t>
        edge;  // 1 where a pixel's ray tree differs from a neighbour's, dilated by one
};

// What stage 01 shows of a scene; every other stage shows its light.
enum class Shown { light, normals_and_distances };

// Renders with one ray through each pixel's centre, on all cores. Number is float,
// double or long double.
template <typename Number>
Result render(const Scene &scene, const Settings &settings, Shown shown = Shown::light);

// For each of `pixels` (column, row) the colours at points around its centre, at distances from
// a hundred-thousandth of a pixel to `reach` pixels. A device that rounds differently stands on the
// other side of an edge, and sees what is there: one of these.
std::vector<std::vector<glm::vec3>> colors_around(const Scene &scene, const Settings &settings,
                                                  const std::vector<glm::ivec2> &pixels,
                                                  double reach);

}  // namespace stagelight::reference
