// SPDX-License-Identifier: MIT
#include "device/bvh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <future>
#include <limits>
#include <numeric>
#include <thread>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "scene_types.h"

namespace stagelight {
namespace {

constexpr std::uint32_t most_in_leaf = 8;
constexpr std::uint32_t parallel_from = 4096;  // triangles: a thread for fewer costs more
constexpr int bin_count = 16;
constexpr float traversal_cost = 1;  // of a node, in triangles: 0.5 to 1.5 are as good
constexpr int deepest_by_cost = 32;  // then halves, so that the depth stays bounded

struct Box {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};

    void add(const glm::vec3 &point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void add(const Box &box) {
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
    }
    glm::vec3 center() const { return 0.5F * low + 0.5F * high; }  // low + high may overflow
    float half_area() const {
        const glm::vec3 size = high - low;
        return size.x < 0 ? 0 : size.x * size.y + size.y * size.z + size.z * size.x;
    }
};

struct Range {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t size() const { return end - begin; }
};

struct Split {
    int axis = -1;
    int bin = 0;  // the last on the left
    float cost = std::numeric_limits<float>::infinity();
};

// A part of the tree while it is built: a leaf, or the branch that divides it.
struct Part {
    Box box;
    Range range;
    std::uint32_t branch = 0;  // 0 for a leaf
};

// It lies at the place where it divides its range, which is no other's: so threads need not
// ask each other for room.
struct Branch {
    Part left, right;
};

class Builder {
public:
    Builder(const Scene &scene, const BvhLayout &layout) : boxes_(scene.triangles.size()) {
        bvh_.layout = layout;
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            for (const std::uint32_t vertex : scene.triangles[i].vertices) {
                boxes_[i].add(glm::vec3(scene.vertices[vertex].position));
            }
        }
        bvh_.order.resize(boxes_.size());
        std::iota(bvh_.order.begin(), bvh_.order.end(), 0U);
        branches_.resize(boxes_.size());
    }

    Bvh build() {
        if (boxes_.empty()) {
            return {};
        }
        const Range all{0, static_cast<std::uint32_t>(boxes_.size())};
        const auto levels_of_threads =
            static_cast<int>(std::bit_width(std::thread::hardware_concurrency()));
        const Part root = divide(all, 0, levels_of_threads);
        const glm::vec3 largest = glm::max(glm::abs(root.box.low), glm::abs(root.box.high));
        if (bvh_.layout.has_room) {
            room_ = SLAB_ROOM * std::max({largest.x, largest.y, largest.z});
        }
        emit(children_of(root), 1);
        return std::move(bvh_);
    }

private:
    glm::vec3 centroid(std::uint32_t place) const { return boxes_[bvh_.order[place]].center(); }

    Box bounds(const Range &range) const {
        Box box;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            box.add(boxes_[bvh_.order[i]]);
        }
        return box;
    }

    Box centroid_bounds(const Range &range) const {
        Box box;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            box.add(centroid(i));
        }
        return box;
    }

    static int bin_of(float centroid, float low, float high) {
        const float share = (0.5F * centroid - 0.5F * low) / (0.5F * high - 0.5F * low);
        return std::clamp(static_cast<int>(share * bin_count), 0, bin_count - 1);
    }

    // The cheapest plane between two bins of one axis, by the areas on both sides.
    Split best_split(const Range &range, const Box &centroids, int axis) const {
        std::array<Box, bin_count> boxes;
        std::array<std::uint32_t, bin_count> counts{};
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const auto bin = static_cast<std::size_t>(
                bin_of(centroid(i)[axis], centroids.low[axis], centroids.high[axis]));
            boxes[bin].add(boxes_[bvh_.order[i]]);
            ++counts[bin];
        }
        // #region sweep
        std::array<float, bin_count> right_cost{};
        Box box;
        std::uint32_t count = 0;
        for (std::size_t bin = bin_count - 1; bin > 0; --bin) {
            box.add(boxes[bin]);
            count += counts[bin];
            right_cost[bin] = box.half_area() * static_cast<float>(count);
        }
        Split best;
        box = Box();
        count = 0;
        for (std::size_t bin = 0; bin + 1 < bin_count; ++bin) {
            box.add(boxes[bin]);
            count += counts[bin];
            const float cost = box.half_area() * static_cast<float>(count) + right_cost[bin + 1];
            if (count > 0 && count < range.size() && cost < best.cost) {
                best = {axis, static_cast<int>(bin), cost};
            }
        }
        return best;
        // #endregion sweep
    }

    // Where the range is cut in two, its triangles put on their sides; the range's begin where it
    // had better be a leaf.
    std::uint32_t partition(const Range &range, const Box &box, int depth) {
        const Box centroids = centroid_bounds(range);
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (centroids.high[axis] > centroids.low[axis]) {
                const Split split = best_split(range, centroids, axis);
                best = split.cost < best.cost ? split : best;
            }
        }
        // #region pays
        const float as_leaf = box.half_area() * static_cast<float>(range.size());
        const bool pays = best.cost + traversal_cost * box.half_area() < as_leaf;
        if (range.size() <= most_in_leaf && !pays) {
            return range.begin;
        }
        // #endregion pays
        const auto begin = bvh_.order.begin() + range.begin;
        const auto end = bvh_.order.begin() + range.end;
        if (best.axis < 0 || depth >= deepest_by_cost) {
            return halve(range, centroids);
        }
        const auto middle = std::partition(begin, end, [&](std::uint32_t triangle) {
            return bin_of(boxes_[triangle].center()[best.axis], centroids.low[best.axis],
                          centroids.high[best.axis])
                   <= best.bin;
        });
        return static_cast<std::uint32_t>(middle - bvh_.order.begin());
    }

    // By count, along the longest side: for a million triangles in one place, and where costs
    // led too deep.
    std::uint32_t halve(const Range &range, const Box &centroids) {
        const glm::vec3 size = centroids.high - centroids.low;
        const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const std::uint32_t middle = range.begin + range.size() / 2;
        const auto at = [this](std::uint32_t place) { return bvh_.order.begin() + place; };
        std::nth_element(at(range.begin), at(middle), at(range.end),
                         [&](std::uint32_t a, std::uint32_t b) {
                             const float of_a = boxes_[a].center()[axis];
                             const float of_b = boxes_[b].center()[axis];
                             return of_a < of_b || (of_a == of_b && a < b);
                         });
        return middle;
    }

    Part divide(const Range &range, int depth, int levels_of_threads) {
        Part part{bounds(range), range, 0};
        const std::uint32_t middle = partition(range, part.box, depth);
        if (middle == range.begin) {
            return part;
        }
        part.branch = middle;
        Branch &branch = branches_[middle];
        const auto left = [&] {
            return divide({range.begin, middle}, depth + 1, levels_of_threads - 1);
        };
        const bool in_parallel = levels_of_threads > 0 && range.size() >= parallel_from;
        auto left_part = std::async(in_parallel ? std::launch::async : std::launch::deferred, left);
        branch.right = divide({middle, range.end}, depth + 1, levels_of_threads - 1);
        branch.left = left_part.get();
        return part;
    }

    // #region children_of
    // Its two children; then, while there is room, the largest that is no leaf gives way to its own
    // two.
    std::vector<Part> children_of(const Part &part) const {
        std::vector<Part> children{part};
        while (children.size() < width()) {
            const auto largest = std::ranges::max_element(children, {}, [](const Part &child) {
                return child.branch == 0 ? -1.0F : child.box.half_area();
            });
            if (largest->branch == 0) {
                break;
            }
            const Branch &branch = branches_[largest->branch];
            *largest = branch.left;
            children.insert(largest + 1, branch.right);
        }
        return children;
    }
    // #endregion children_of

    // Depth first, so that what is walked together lies together. When it is taken up, `waiting`
    // nodes are left, itself among them.
    std::uint32_t emit(const std::vector<Part> &children, int waiting) {
        bvh_.stack_size = std::max(bvh_.stack_size, waiting);
        const std::size_t node = bvh_.nodes.size();
        const std::size_t words = 8 * width();  // six planes, first and count
        bvh_.nodes.resize(node + words);
        const auto is_inner = [](const Part &child) { return child.branch != 0; };
        const auto inner = static_cast<int>(std::ranges::count_if(children, is_inner));
        for (std::size_t i = 0; i < width(); ++i) {
            // In the place of one that is missing, a box that no ray meets.
            const Part child = i < children.size() ? children[i] : Part{{}, {0, 1}, 0};
            const std::uint32_t first =
                is_inner(child) ? emit(children_of(child), waiting - 1 + inner) : child.range.begin;
            put_child(node, i, child, first);
        }
        return static_cast<std::uint32_t>(node / words);
    }

    std::size_t width() const { return static_cast<std::size_t>(bvh_.layout.width); }

    void put_child(std::size_t node, std::size_t index, const Part &child, std::uint32_t first) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<std::size_t>(axis) * width() + index;
            put_plane(node + row, child.box.low[axis] - room_);
            put_plane(node + 3 * width() + row, child.box.high[axis] + room_);
        }
        const std::size_t children = node + 6 * width() + index;
        bvh_.nodes[children] = first;
        bvh_.nodes[children + width()] = child.branch == 0 ? child.range.size() : 0;
    }

    void put_plane(std::size_t place, float plane) {
        bvh_.nodes[place] = std::bit_cast<std::uint32_t>(plane);
    }

    float room_ = 0;  // how far boxes are grown on every side
    std::vector<Box> boxes_;
    std::vector<Branch> branches_;
    Bvh bvh_;
};

}  // namespace

Bvh build_bvh(const Scene &scene, const BvhLayout &layout) {
    return Builder(scene, layout).build();
}

}  // namespace stagelight
