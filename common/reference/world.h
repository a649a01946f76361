// SPDX-License-Identifier: MIT
// A scene made ready for rays: the closest hit, and whether anything is in the way (paper,
// section 2: "loops over all geometry and performs intersection tests").
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "reference/hit.h"
#include "reference/patches.h"
#include "scene/bodies.h"

namespace stagelight::reference {

template <typename Number> class World {
public:
    explicit World(const Scene &scene)
        : scene_(scene), bodies_(bodies_of(scene)), tree_(scene), patches_(smooth_patches(scene)) {}

    const Scene &scene() const { return scene_; }
    const Bodies &bodies() const { return bodies_; }

    std::optional<Hit<Number>> closest_hit(const Ray<Number> &ray) const {
        const Nearest nearest = search(ray);
        if (nearest.kind == Surface::Kind::none)
            return std::nullopt;
        Hit<Number> hit = hit_on(nearest, ray);
        hit.surface = {nearest.kind, int(nearest.index)};
        if (nearest.kind == Surface::Kind::patch)
            hit.surface.index = patches_[nearest.index];
        hit.body = body_of(nearest);
        return turned_to_eye(hit, ray.direction);
    }

    // Those that hold a point, in ascending order: they are seen from behind from there.
    std::vector<int> bodies_at(const Vec<Number> &point) const;

    bool blocked(const Ray<Number> &ray) const;
    bool blocked(const Line<Number> &line) const;

private:
    struct Nearest {
        Surface::Kind kind = Surface::Kind::none;
        std::size_t index = 0;
        Number distance = std::numeric_limits<Number>::infinity();
        TriangleHit<Number> on_triangle{};

        void offer(Surface::Kind of_kind, std::size_t i, const std::optional<Number> &at) {
            if (at && *at < distance)
                *this = {of_kind, i, *at, {}};
        }
    };

    // Where the triangle is met, unless its texture's alpha cuts it out there.
    bool is_there(std::size_t index, const TriangleHit<Number> &hit) const {
        const Triangle &triangle = scene_.triangles[index];
        const Material &material = scene_.materials[std::size_t(triangle.material)];
        return !has_cutout(material)
               || !(sample_alpha(scene_.textures[std::size_t(material.texture)],
                                 coordinates_at(scene_, triangle, hit))
                    < Number(material.alpha_cutoff));
    }

    Nearest search(const Ray<Number> &ray) const;
    void add_bodies_behind(Ray<Number> ray, std::map<int, bool> &holds) const;

    int body_of(const Nearest &nearest) const {
        switch (nearest.kind) {
        case Surface::Kind::sphere:
            return bodies_.of_sphere[nearest.index];
        case Surface::Kind::plane:
            return bodies_.of_plane[nearest.index];
        default:
            return bodies_.of_triangle[nearest.index];
        }
    }

    Hit<Number> hit_on(const Nearest &nearest, const Ray<Number> &ray) const {
        switch (nearest.kind) {
        case Surface::Kind::sphere:
            return sphere_hit(scene_.spheres[nearest.index], ray, nearest.distance);
        case Surface::Kind::plane:
            return plane_hit(scene_.planes[nearest.index], ray, nearest.distance);
        default:
            return triangle_hit(scene_, scene_.triangles[nearest.index], nearest.on_triangle);
        }
    }

    const Scene &scene_;
    Bodies bodies_;
    TriangleTree<Number> tree_;
    std::vector<int> patches_;
};

template <typename Number>
typename World<Number>::Nearest World<Number>::search(const Ray<Number> &ray) const {
    Nearest nearest;
    for (std::size_t i = 0; i < scene_.spheres.size(); ++i)
        nearest.offer(Surface::Kind::sphere, i,
                      intersect_sphere(ray, Vec<Number>(scene_.spheres[i].center),
                                       Number(scene_.spheres[i].radius)));
    for (std::size_t i = 0; i < scene_.planes.size(); ++i)
        nearest.offer(Surface::Kind::plane, i,
                      intersect_plane(ray, Vec<Number>(scene_.planes[i].normal),
                                      Vec<Number>(scene_.planes[i].point)));
    tree_.search(ray, nearest.distance, [&](std::size_t i) {
        const auto hit = intersect_triangle(ray, tree_.corners(i));
        if (hit && hit->distance < nearest.distance && is_there(i, *hit))
            nearest = {Surface::Kind::patch, i, hit->distance, *hit};
        return false;
    });
    return nearest;
}

// Of each body that the ray meets, whether it comes out of it first.
template <typename Number>
void World<Number>::add_bodies_behind(Ray<Number> ray, std::map<int, bool> &holds) const {
    while (const auto hit = closest_hit(ray)) {
        if (hit->body >= 0)
            holds.emplace(hit->body, hit->from_behind);
        ray.origin = hit->point - hit->offset * hit->geometric_normal;
    }
}

template <typename Number>
std::vector<int> World<Number>::bodies_at(const Vec<Number> &point) const {
    std::map<int, bool> holds;
    if (!bodies_.list.empty()) {
        const Vec<Number> up = glm::normalize(Vec<Number>(Number(0.36), Number(0.87), Number(0.2)));
        add_bodies_behind({point, up}, holds);
        add_bodies_behind({point, -up}, holds);  // a half-space may lie that way alone
    }
    std::vector<int> bodies;
    for (const auto &[body, is_inside] : holds)
        if (is_inside)
            bodies.push_back(body);
    return bodies;
}

template <typename Number> bool World<Number>::blocked(const Ray<Number> &ray) const {
    return search(ray).kind != Surface::Kind::none;
}

template <typename Number> bool World<Number>::blocked(const Line<Number> &line) const {
    const auto by_sphere = [&](const Sphere &it) {
        return line_meets_sphere(line, Vec<Number>(it.center), Number(it.radius));
    };
    const auto by_plane = [&](const Plane &it) {
        return line_meets_plane(line, Vec<Number>(it.normal), Vec<Number>(it.point));
    };
    const auto by_triangle = [&](std::size_t i) {
        if (!line_meets_triangle(line, tree_.corners(i)))
            return false;
        const auto hit = intersect_triangle(ray_along(line), tree_.corners(i));
        return !hit || is_there(i, *hit);
    };
    const Number length = glm::distance(line.origin, line.destination);
    return std::any_of(scene_.spheres.begin(), scene_.spheres.end(), by_sphere)
           || std::any_of(scene_.planes.begin(), scene_.planes.end(), by_plane)
           || tree_.search(ray_along(line), length, by_triangle);
}

}  // namespace stagelight::reference
