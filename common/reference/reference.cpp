// SPDX-License-Identifier: MIT
#include "reference/reference.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <thread>

#include "reference/camera.h"
#include "reference/ray_tree.h"
#include "reference/tracer.h"
#include "reference/view.h"

namespace stagelight::reference {

namespace {

struct Row {
    std::vector<glm::vec3> colors;
    std::vector<RayTree> trees;
};

// A picture in the making. Ray trees are large, so that a thread keeps two rows of them.
template <typename Number> class Renderer {
public:
    Renderer(const Scene &scene, const Settings &settings, Shown shown)
        : world_(scene), settings_(settings), shown_(shown), tracer_(world_, settings_),
          image_(settings.width, settings.height), seams_(image_.pixels.size()) {}

    Result render() {
        {
            std::vector<std::jthread> threads;
            for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
                threads.emplace_back([this] { work(); });
        }
        return {std::move(image_), edge_mask(settings_.width, settings_.height, seams_)};
    }

private:
    static constexpr int band_height = 16;

    void work() {
        for (int top; (top = next_band_++ * band_height) < settings_.height;)
            render_band(top, std::min(top + band_height, settings_.height));
    }

    // The row below the band is traced too, for the seams between: it is kept by its own band.
    void render_band(int top, int bottom) {
        Row row = trace_row(top);
        for (int y = top; y < bottom; ++y) {
            Row below = y + 1 < settings_.height ? trace_row(y + 1) : Row{};
            keep(y, row, below);
            row = std::move(below);
        }
    }

    Row trace_row(int y) const {
        const auto width = std::size_t(settings_.width);
        Row row{std::vector<glm::vec3>(width), std::vector<RayTree>(width)};
        for (std::size_t x = 0; x < width; ++x) {
            const auto ray = primary_ray(world_.scene().camera, settings_.width, settings_.height,
                                         Number(x) + Number(0.5), Number(y) + Number(0.5));
            row.colors[x] = glm::vec3(shown_ == Shown::light
                                          ? tracer_.light(ray, row.trees[x])
                                          : normals_and_distances(world_, ray, row.trees[x]));
        }
        return row;
    }

    void keep(int y, const Row &row, const Row &below) {
        const std::size_t start = std::size_t(y) * row.colors.size();
        for (std::size_t x = 0; x < row.colors.size(); ++x) {
            image_.pixels[start + x] = row.colors[x];
            const bool right = x + 1 < row.trees.size() && differ(row.trees[x], row.trees[x + 1]);
            const bool under = !below.trees.empty() && differ(row.trees[x], below.trees[x]);
            seams_[start + x] = static_cast<std::uint8_t>((right ? seam_right : no_seam)
                                                          | (under ? seam_below : no_seam));
        }
    }

    World<Number> world_;
    Settings settings_;
    Shown shown_;
    Tracer<Number> tracer_;
    Image image_;
    std::vector<std::uint8_t> seams_;
    std::atomic<int> next_band_ = 0;
};

}  // namespace

template <typename Number>
Result render(const Scene &scene, const Settings &settings, Shown shown) {
    return Renderer<Number>(scene, settings, shown).render();
}

std::vector<std::vector<glm::vec3>> colors_around(const Scene &scene, const Settings &settings,
                                                  const std::vector<glm::ivec2> &pixels,
                                                  double reach) {
    constexpr int directions = 32;
    const World<double> world(scene);
    const Tracer<double> tracer(world, settings);
    std::vector<std::vector<glm::vec3>> colors(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        // A few steps, each a third of the last.
        // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter)
        for (double distance = reach; distance > 1e-5; distance /= 3) {
            for (int k = 0; k < directions; ++k) {
                const double angle = 2 * std::numbers::pi * k / directions;
                RayTree tree;
                const Ray<double> ray = primary_ray(scene.camera, settings.width, settings.height,
                                                    pixels[i].x + 0.5 + distance * std::cos(angle),
                                                    pixels[i].y + 0.5 + distance * std::sin(angle));
                colors[i].emplace_back(tracer.light(ray, tree));
            }
        }
    }
    return colors;
}

template Result render<float>(const Scene &, const Settings &, Shown);
template Result render<double>(const Scene &, const Settings &, Shown);
template Result render<long double>(const Scene &, const Settings &, Shown);

}  // namespace stagelight::reference
