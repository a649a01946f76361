// SPDX-License-Identifier: MIT
// Whitted's recursion (An Improved Illumination Model for Shaded Display, 1980; paper,
// sections 2, 4 and 5), with the exact rules of docs/shading.md.
#pragma once

#include <algorithm>
#include <vector>

#include "reference/direct_light.h"
#include "reference/optics.h"
#include "reference/reference.h"

namespace stagelight::reference {

template <typename Number> class Tracer {
public:
    Tracer(const World<Number> &world, const Settings &settings)
        : world_(world), scene_(world.scene()), settings_(settings), eye_(scene_.camera.position),
          at_eye_(world.bodies_at(eye_)) {}

    // What the ray sees.
    Vec<Number> light(const Ray<Number> &ray, RayTree &tree) const {
        return trace(ray, {.bodies = ray.origin == eye_ ? at_eye_ : world_.bodies_at(ray.origin)},
                     tree);
    }

private:
    // How a ray came to be.
    struct Path {
        int depth = 0;
        std::vector<int> bodies{};  // the dielectrics it is inside of, in order of precedence
        Vec<Number> weight{1};      // the share of what it sees in the pixel
    };

    // A hit with all that shading asks of it.
    struct Meeting {
        Hit<Number> hit;
        Vec<Number> direction;  // of the ray
        Path path;              // of the ray, its weight as it is at the hit
        const Material &material;
        Vec<Number> color;  // the material's, times those of vertices and of the texel
        RayTree &tree;
    };

    Vec<Number> trace(const Ray<Number> &ray, Path path, RayTree &tree) const;
    Vec<Number> shade(const Meeting &at) const;
    Vec<Number> lit(const Meeting &at) const;
    Vec<Number> reflected(const Meeting &at, const Vec<Number> &share) const;
    Vec<Number> dielectric(const Meeting &at) const;
    Vec<Number> through_interior(const Meeting &at, const Vec<Number> &inward,
                                 const Vec<Number> &share) const;
    Vec<Number> spawn(const Meeting &at, const Ray<Number> &ray, const std::vector<int> &bodies,
                      const Vec<Number> &share) const;

    // Of the bodies that hold a point the last one is there (Schmidt and Budge, Simple Nested
    // Dielectrics in Ray Traced Images, 2002); nullptr where it is air.
    const Material *medium_of(const std::vector<int> &bodies) const {
        return bodies.empty() ? nullptr
                              : &scene_.materials[std::size_t(
                                  world_.bodies().list[std::size_t(bodies.back())].material)];
    }

    // What is left of light after a way through them.
    Vec<Number> left_after(const std::vector<int> &bodies, Number distance) const {
        const Material *medium = medium_of(bodies);
        return medium ? transmittance(Vec<Number>(medium->absorption), distance) : Vec<Number>(1);
    }

    Vec<Number> color_of(const Material &material, const Hit<Number> &hit) const {
        const Vec<Number> color = Vec<Number>(material.color) * hit.vertex_color;
        return material.texture == no_texture
                   ? color
                   : color
                         * sample_texture(scene_.textures[std::size_t(material.texture)],
                                          settings_.decode, hit.texture_coordinates);
    }

    const World<Number> &world_;
    const Scene &scene_;
    const Settings &settings_;
    Vec<Number> eye_;
    std::vector<int> at_eye_;  // the bodies that hold it
};

// The bodies on the other side of a surface of one of them.
inline std::vector<int> bodies_beyond(std::vector<int> bodies, int body, bool from_behind) {
    std::erase(bodies, body);
    if (!from_behind)
        bodies.insert(std::upper_bound(bodies.begin(), bodies.end(), body), body);
    return bodies;
}

template <typename Number>
Vec<Number> Tracer<Number>::trace(const Ray<Number> &ray, Path path, RayTree &tree) const {
    tree.weight = double(largest(path.weight));
    const auto hit = world_.closest_hit(ray);
    if (!hit)  // what absorbs at all lets nothing through that has no end
        return left_after(path.bodies, std::numeric_limits<Number>::max())
               * Vec<Number>(scene_.background);
    const Vec<Number> left = left_after(path.bodies, hit->distance);
    path.weight *= left;
    tree.weight = double(largest(path.weight));
    record(tree, *hit);
    const Material &material = scene_.materials[std::size_t(hit->material)];
    return left * shade({*hit, ray.direction, path, material, color_of(material, *hit), tree});
}

template <typename Number> Vec<Number> Tracer<Number>::shade(const Meeting &at) const {
    const auto s = Number(at.material.specularity);
    switch (at.material.type) {
    case MaterialType::diffuse:
        return at.color * lit(at);
    case MaterialType::mirror:
        return reflected(at, at.color);
    case MaterialType::glossy:
        return (1 - s) * at.color * lit(at) + reflected(at, s * at.color);
    case MaterialType::dielectric:
        return dielectric(at);
    }
    return {};
}

// Straight from the lights. Hanika's rule has them seen from the smooth surface.
template <typename Number> Vec<Number> Tracer<Number>::lit(const Meeting &at) const {
    Hit<Number> hit = at.hit;
    if (settings_.terminator == Terminator::hanika)
        hit.point += hit.rise;
    return direct_light(world_, hit, at.tree.shadows, settings_.terminator);
}

template <typename Number>
Vec<Number> Tracer<Number>::reflected(const Meeting &at, const Vec<Number> &share) const {
    const Hit<Number> &hit = at.hit;
    const auto direction = reflect(at.direction, hit.shading_normal, hit.geometric_normal);
    return spawn(at, ray_off_surface(hit.point, hit.geometric_normal, direction, hit.offset),
                 at.path.bodies, share);
}

// Snell, Schlick and Beer (docs/shading.md, "Dielectrics").
template <typename Number> Vec<Number> Tracer<Number>::dielectric(const Meeting &at) const {
    const Hit<Number> &hit = at.hit;
    const std::vector<int> without = bodies_beyond(at.path.bodies, hit.body, true);
    const std::vector<int> beyond = bodies_beyond(at.path.bodies, hit.body, hit.from_behind);
    const Vec<Number> off_far_side = hit.point - hit.offset * hit.geometric_normal;
    if (!without.empty() && without.back() > hit.body) {  // another is there on both sides
        RayTree &child = at.tree.children.emplace_back();
        return trace({off_far_side, at.direction}, {at.path.depth, beyond, at.path.weight}, child);
    }
    const Material *around = medium_of(without);
    const auto ior = Number(at.material.ior), outside = around ? Number(around->ior) : 1;
    const Number n1 = hit.from_behind ? ior : outside, n2 = hit.from_behind ? outside : ior;
    const Number cosine1 = -glm::dot(at.direction, hit.shading_normal);
    const auto refraction =
        cosine1 > 0 ? refract(at.direction, hit.shading_normal, n1, n2) : std::nullopt;
    const auto share = settings_.fresnel == Fresnel::exact ? fresnel<Number> : schlick<Number>;
    const Number reflectance = refraction ? share(n1, n2, cosine1, refraction->cosine) : 1;

    const bool single_pass =
        settings_.interior == Interior::paper && hit.surface.kind == Surface::Kind::sphere;
    Vec<Number> sum(0);
    if (!(single_pass && hit.from_behind))
        sum += reflected(at, reflectance * at.color);
    if (!refraction)
        return sum;
    if (single_pass && !hit.from_behind)
        return sum + through_interior(at, refraction->direction, (1 - reflectance) * at.color);
    const Ray<Number> transmitted{off_far_side,
                                  beneath(refraction->direction, hit.geometric_normal)};
    return sum + spawn(at, transmitted, beyond, (single_pass ? 1 : 1 - reflectance) * at.color);
}

// The paper's section 5: from the hit along `inward` to the sphere's far wall, absorbed on the
// way, and out, with no reflection inside.
template <typename Number>
Vec<Number> Tracer<Number>::through_interior(const Meeting &at, const Vec<Number> &inward,
                                             const Vec<Number> &share) const {
    const Hit<Number> &hit = at.hit;
    const auto radius = Number(scene_.spheres[std::size_t(hit.surface.index)].radius);
    const Number chord = -2 * radius * glm::dot(inward, hit.geometric_normal);
    const Vec<Number> far_wall = hit.point + chord * inward;
    const Vec<Number> far_normal = hit.geometric_normal + chord / radius * inward;
    const auto outward = refract(inward, -far_normal, Number(at.material.ior), Number(1));
    if (!outward)
        return Vec<Number>(0);
    return spawn(at, ray_off_surface(far_wall, far_normal, outward->direction, hit.offset),
                 at.path.bodies, share * transmittance(Vec<Number>(at.material.absorption), chord));
}

// What a ray that starts at a hit adds to what is seen there. Rays too deep are dropped, and
// with them what rounding swallows: glass facing glass would spawn two rays of each.
template <typename Number>
Vec<Number> Tracer<Number>::spawn(const Meeting &at, const Ray<Number> &ray,
                                  const std::vector<int> &bodies, const Vec<Number> &share) const {
    if (at.path.depth == settings_.max_depth)
        return Vec<Number>(0);
    RayTree &child = at.tree.children.emplace_back();
    const Path path{at.path.depth + 1, bodies, at.path.weight * share};
    if (largest(path.weight) < std::numeric_limits<Number>::epsilon())
        return Vec<Number>(0);
    const Vec<Number> seen = share * trace(ray, path, child);
    if (child.weight < least_weight)
        child.children.clear();  // nobody looks at them; spares memory
    return seen;
}

}  // namespace stagelight::reference
