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
constexpr std::uint32_t parallel_from = 4096;  // shapes: a thread for fewer costs more
constexpr std::size_t child_count = 4;         // of a node: a vector holds a plane of each
constexpr int bin_count = 16;
constexpr float traversal_cost = 1;  // of a node, in shapes: 0.5 to 1.5 are as good
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
    explicit Builder(const Scene &scene)
        : triangle_count_(static_cast<std::uint32_t>(scene.triangles.size())) {
        boxes_.reserve(scene.triangles.size() + scene.spheres.size());
        for (const Triangle &triangle : scene.triangles) {
            Box box;
            for (const std::uint32_t vertex : triangle.vertices) {
                box.add(glm::vec3(scene.vertices[vertex].position));
            }
            boxes_.push_back(box);
        }
        for (const Sphere &sphere : scene.spheres) {
            const glm::vec3 center(sphere.center);
            const auto radius = static_cast<float>(sphere.radius);
            boxes_.push_back({center - radius, center + radius});
        }
        order_.resize(boxes_.size());
        std::iota(order_.begin(), order_.end(), 0U);
        branches_.resize(boxes_.size());
    }

    Bvh build(bool padded) {
        if (boxes_.empty()) {
            return {};
        }
        const Range all{0, static_cast<std::uint32_t>(boxes_.size())};
        const auto levels_of_threads =
            static_cast<int>(std::bit_width(std::thread::hardware_concurrency()));
        const Part root = divide(all, 0, levels_of_threads);
        const glm::vec3 largest = glm::max(glm::abs(root.box.low), glm::abs(root.box.high));
        if (padded) {
            padding_ = SLAB_PADDING * std::max({largest.x, largest.y, largest.z});
        }
        bvh_.triangles.reserve(triangle_count_);
        emit(children_of(root), 1);
        return std::move(bvh_);
    }

private:
    glm::vec3 centroid(std::uint32_t place) const { return boxes_[order_[place]].center(); }

    Box bounds(const Range &range) const {
        Box box;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            box.add(boxes_[order_[i]]);
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
            boxes[bin].add(boxes_[order_[i]]);
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

    bool is_sphere(std::uint32_t shape) const { return shape >= triangle_count_; }

    // Where the triangles of a range end and its spheres begin; its begin where it has one kind
    // only.
    std::uint32_t divide_kinds(const Range &range) {
        const auto begin = order_.begin() + range.begin;
        const auto end = order_.begin() + range.end;
        const auto middle =
            std::partition(begin, end, [this](std::uint32_t shape) { return !is_sphere(shape); });
        return middle == end ? range.begin : static_cast<std::uint32_t>(middle - order_.begin());
    }

    // Where the range is cut in two, its shapes put on their sides; the range's begin where it had
    // better be a leaf.
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
            return divide_kinds(range);
        }
        // #endregion pays
        const auto begin = order_.begin() + range.begin;
        const auto end = order_.begin() + range.end;
        if (best.axis < 0 || depth >= deepest_by_cost) {
            return halve(range, centroids);
        }
        const auto middle = std::partition(begin, end, [&](std::uint32_t shape) {
            return bin_of(boxes_[shape].center()[best.axis], centroids.low[best.axis],
                          centroids.high[best.axis])
                   <= best.bin;
        });
        return static_cast<std::uint32_t>(middle - order_.begin());
    }

    // By count, along the longest side: for a million shapes in one place, and where costs
    // led too deep.
    std::uint32_t halve(const Range &range, const Box &centroids) {
        const glm::vec3 size = centroids.high - centroids.low;
        const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const std::uint32_t middle = range.begin + range.size() / 2;
        const auto at = [this](std::uint32_t place) { return order_.begin() + place; };
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
        while (children.size() < child_count) {
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
    cl_int emit(const std::vector<Part> &children, int waiting) {
        bvh_.stack_size = std::max(bvh_.stack_size, waiting);
        const std::size_t node = bvh_.nodes.size();
        bvh_.nodes.emplace_back();
        const auto is_inner = [](const Part &child) { return child.branch != 0; };
        const auto inner = static_cast<int>(std::ranges::count_if(children, is_inner));
        for (std::size_t i = 0; i < child_count; ++i) {
            if (i >= children.size()) {
                put_child(node, i, {{}, {0, 1}, 0}, 0);  // a box that no ray meets
                continue;
            }
            const Part &child = children[i];
            put_child(node, i, child,
                      is_inner(child) ? emit(children_of(child), waiting - 1 + inner)
                                      : emit_leaf(child.range));
        }
        return static_cast<cl_int>(node);
    }

    // The first of its shapes, in the order of those of its kind.
    cl_int emit_leaf(const Range &range) {
        const bool spheres = is_leaf_of_spheres(range);
        std::vector<std::uint32_t> &shapes = spheres ? bvh_.spheres : bvh_.triangles;
        const auto first = static_cast<cl_int>(shapes.size());
        for (std::uint32_t place = range.begin; place < range.end; ++place) {
            shapes.push_back(order_[place] - (spheres ? triangle_count_ : 0));
        }
        return first;
    }

    bool is_leaf_of_spheres(const Range &range) const { return is_sphere(order_[range.begin]); }

    void put_child(std::size_t node, std::size_t index, const Part &child, cl_int first) {
        device::BvhNode &into = bvh_.nodes[node];
        for (int axis = 0; axis < 3; ++axis) {
            into.planes[axis].s[index] = child.box.low[axis] - padding_;
            into.planes[axis + 3].s[index] = child.box.high[axis] + padding_;
        }
        const auto count = static_cast<cl_int>(child.range.size());
        into.first[index] = first;
        into.count[index] = child.branch != 0                 ? 0
                            : is_leaf_of_spheres(child.range) ? -count
                                                              : count;
    }

    float padding_ = 0;  // on every side of a box
    std::uint32_t triangle_count_;
    std::vector<Box> boxes_;  // of all triangles, then of all spheres
    std::vector<std::uint32_t> order_;
    std::vector<Branch> branches_;
    Bvh bvh_;
};

}  // namespace

Bvh build_bvh(const Scene &scene, bool padded) {
    return Builder(scene).build(padded);
}

}  // namespace stagelight
