// SPDX-License-Identifier: MIT
// Pictures of many sizes in one array of images, and places on them.
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "kernels/on_device.h"
#include "kernels/worst.h"
#include "reference/scenes.h"
#include "reference/textures.h"

namespace stagelight {

// Pictures of many sizes, each worn by a material of its index; the last material has none.
// `texel` makes four bytes of the picture, column and row.
template <typename Texel> Scene scene_of_pictures(Texel texel) {
    constexpr std::pair<int, int> sizes[]{{1, 1},  {2, 3},   {7, 5}, {64, 32},
                                          {5, 64}, {16, 16}, {3, 1}};
    Scene scene;
    for (const auto &[width, height] : sizes) {
        const auto picture = int(scene.textures.size());
        std::vector<std::uint8_t> texels;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const std::array<int, 3> rgb = texel(picture, x, y);
                texels.insert(texels.end(), rgb.begin(), rgb.end());
                texels.push_back(255);
            }
        }
        scene.textures.push_back(reference::texture_of(width, height, texels));
        scene.materials.push_back({.texture = picture, .where = {}});
    }
    scene.materials.push_back({.where = {}});
    return scene;
}

inline const SceneNeeds with_pictures{{"HAS_MATERIALS", 1}, {"HAS_TEXTURES", 1}};

// Places in and far outside of each picture, on its border, at its texels' centres.
inline std::vector<glm::vec4> places(const Scene &scene) {
    reference::Dice dice;
    std::vector<glm::vec4> result;
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        const Texture &texture = scene.textures[i];
        const auto add = [&](double u, double v) { result.emplace_back(u, v, i, 0); };
        for (const double u : {0.0, 1.0, -0.0, 1 - 1e-7, -1e-9, -1e-3, 2.0, -3.0, 1e5 + 0.25}) {
            add(u, dice.between(0, 1));
            add(dice.between(0, 1), u);
            add(u, u);
        }
        for (int k = 0; k < 512; ++k) {
            add(dice.between(0, 1), dice.between(0, 1));
            add(dice.between(-9, 9), dice.between(-9, 9));
            // Across the border, and on a texel's centre.
            add(dice.between(-0.5, 0.5) / texture.width, dice.between(-0.5, 0.5) / texture.height);
            add((std::floor(dice.between(0, texture.width)) + 0.5) / texture.width,
                (std::floor(dice.between(0, texture.height)) + 0.5) / texture.height);
        }
    }
    return result;
}

// The colours that the device finds at all places, against the reference's.
inline void expect_colors(DeviceProgram program, const Scene &scene, Transfer decode,
                          double rounding_per_texel, double rounding) {
    const std::vector<glm::vec4> at = places(scene);
    const auto colors = program.run_in<glm::vec4>(scene, "colors", at);
    // A place on a layer is rounded by how far it is from the corner.
    const TexturePages pages = pages_of(scene.textures, {16384, 16384, 2048});
    Worst color("colour");
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const Texture &texture = scene.textures[std::size_t(at[i].z)];
        const auto truth = reference::sample_texture(texture, decode, glm::dvec2(at[i].x, at[i].y));
        const TexturePlace &place = pages.places[std::size_t(at[i].z)];
        const double size = double(
            std::max(place.x + std::size_t(texture.width), place.y + std::size_t(texture.height)));
        color.compare(i, glm::dvec3(colors[i]), truth, rounding_per_texel * size + rounding);
    }
    color.expect(14000);
}

// The same pictures, each wrapped one of the nine ways.
inline void wrap_in_all_ways(Scene &scene) {
    constexpr std::array wraps{Wrap::repeat, Wrap::clamp, Wrap::mirror};
    const std::vector<Texture> once = scene.textures;
    scene.textures.clear();
    scene.materials.clear();
    for (const Texture &texture : once) {
        for (std::size_t i = 0; i < 9; ++i) {
            scene.materials.push_back({.texture = int(scene.textures.size()), .where = {}});
            scene.textures.push_back(texture);
            scene.textures.back().wrap_u = wraps.at(i % 3);
            scene.textures.back().wrap_v = wraps.at(i / 3);
        }
    }
}

}  // namespace stagelight
