// SPDX-License-Identifier: MIT
#include "device/texture_pages.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace stagelight {
namespace {

std::size_t width_of(const Texture &texture) {
    return static_cast<std::size_t>(texture.width) + 2;
}

std::size_t height_of(const Texture &texture) {
    return static_cast<std::size_t>(texture.height) + 2;
}

// Textures beside each other, none higher than the first.
struct Shelf {
    std::size_t height = 0;
    std::size_t filled = 0;
    std::vector<std::size_t> textures;
};

// Each texture goes onto the first shelf with room, the highest textures first (Coffman et al.,
// Performance Bounds for Level-Oriented Two-Dimensional Packing Algorithms, 1980).
std::vector<Shelf> shelves_of(const std::vector<Texture> &textures, std::size_t width) {
    std::vector<std::size_t> order(textures.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t i) {
        return std::tuple(height_of(textures[i]), width_of(textures[i]));
    });
    std::vector<Shelf> shelves;
    for (const std::size_t i : order) {
        const std::size_t needed = width_of(textures[i]);
        auto shelf = std::ranges::find_if(
            shelves, [&](const Shelf &it) { return it.filled + needed <= width; });
        if (shelf == shelves.end()) {
            shelf = shelves.insert(shelf, Shelf{.height = height_of(textures[i]), .textures = {}});
        }
        shelf->filled += needed;
        shelf->textures.push_back(i);
    }
    return shelves;
}

// The shelves below each other, on a new layer where one is full.
TexturePages stacked(const std::vector<Texture> &textures, const std::vector<Shelf> &shelves,
                     std::size_t width, std::size_t height) {
    TexturePages pages{.width = width,
                       .height = height,
                       .layers = 1,
                       .places = std::vector<TexturePlace>(textures.size())};
    std::size_t top = 0;
    for (const Shelf &shelf : shelves) {
        if (top + shelf.height > height) {
            ++pages.layers;
            top = 0;
        }
        std::size_t left = 0;
        for (const std::size_t i : shelf.textures) {
            pages.places[i] = {pages.layers - 1, left + 1, top + 1};
            left += width_of(textures[i]);
        }
        top += shelf.height;
    }
    return pages;
}

// Heights of a layer that may leave little of it empty.
std::set<std::size_t> heights_to_try(const std::vector<Shelf> &shelves, std::size_t most) {
    const std::size_t highest = shelves.front().height;
    std::set<std::size_t> heights{highest};
    std::size_t sum = 0;
    for (const Shelf &shelf : shelves) {
        sum += shelf.height;
        heights.insert({sum, highest + shelf.height});
    }
    std::erase_if(heights, [&](std::size_t height) { return height > std::max(most, highest); });
    return heights;
}

}  // namespace

TexturePages pages_of(const std::vector<Texture> &textures, const TextureLimits &limits) {
    if (textures.empty()) {
        return {};
    }
    const std::size_t width = width_of(std::ranges::max(textures, {}, &Texture::width));
    const std::vector<Shelf> shelves = shelves_of(textures, width);
    const auto cost = [&](const TexturePages &pages) {
        return std::tuple(pages.layers > limits.layers, pages.texels(), pages.height);
    };
    TexturePages best;
    for (const std::size_t height : heights_to_try(shelves, limits.height)) {
        TexturePages pages = stacked(textures, shelves, width, height);
        if (best.layers == 0 || cost(pages) < cost(best)) {
            best = std::move(pages);
        }
    }
    return best;
}

}  // namespace stagelight
