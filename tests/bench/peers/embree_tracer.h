// SPDX-License-Identifier: MIT
// The picture of a mesh by Embree: one primary ray a pixel, one shadow line a hit that faces the
// light, shaded as docs/shading.md has it. A scene of triangles with one diffuse material and one
// point light.
#pragma once

#include <cstdint>

#include "bench/peers/embree_scene.h"
#include "bench/peers/workers.h"
#include "image/image.h"
#include "scene/scene.h"
#include "scene_types.h"

namespace stagelight::bench {

enum class EmbreeRays {
    single,  // rtcIntersect1, rtcOccluded1
    packet,  // rtcIntersect16, rtcOccluded16: 4 x 4 pixels, coherent
};

struct EmbreePicture {
    Image image;
    std::uint64_t shadow_rays = 0;
    double milliseconds = 0;
};

class EmbreeTracer {
public:
    // Throws std::invalid_argument for another kind of scene, or a size that is no multiple of a
    // tile's.
    EmbreeTracer(const Scene &scene, const EmbreeScene &embree);

    EmbreePicture render(EmbreeRays rays, Workers &workers) const;

private:
    std::uint64_t draw_tile_singly(Image &image, int left, int top) const;
    std::uint64_t draw_tile_in_packets(Image &image, int left, int top) const;
    std::uint64_t draw_packet(Image &image, int left, int top) const;
    // Not of unit length.
    Vec<float> normal_at(unsigned triangle, float u, float v) const;

    const EmbreeScene &embree_;
    device::Camera camera_;
    Vec<float> eye_, light_;
    glm::vec3 color_;  // the material's, times the light's and its intensity
    glm::vec3 background_;
};

}  // namespace stagelight::bench
