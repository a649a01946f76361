// SPDX-License-Identifier: MIT
// Where a ray met a surface, and how that surface lies there.
#pragma once

#include "reference/intersect.h"
#include "reference/ray_tree.h"
#include "reference/textures.h"
#include "reference/triangle_tree.h"
#include "scene/scene.h"

namespace stagelight::reference {

template <typename Number> struct Hit {
    Number distance;
    Vec<Number> point;
    Vec<Number> shading_normal;    // N of docs/shading.md
    Vec<Number> geometric_normal;  // G
    Vec2<Number> texture_coordinates;
    int material;
    Number offset;  // rays from here start this far off the surface
    Vec<Number> vertex_color{1};
    // From here to the smooth surface that a facet stands for: as it is seen from the front, and
    // from behind.
    Vec<Number> rise{0}, rise_behind{0};
    Surface surface{};  // which one: World says
    int body = -1;      // the dielectric it bounds, of World::bodies(); none of what is opaque
    bool from_behind = false;
};

// The points are put back onto their surfaces, so that how far off they are does not grow
// with the distance the ray came.
template <typename Number>
Hit<Number> sphere_hit(const Sphere &sphere, const Ray<Number> &ray, Number distance) {
    const Vec<Number> center(sphere.center);
    const auto radius = Number(sphere.radius);
    const Vec<Number> normal = glm::normalize(ray.origin + distance * ray.direction - center);
    return {.distance = distance,
            .point = center + radius * normal,
            .shading_normal = normal,
            .geometric_normal = normal,
            .texture_coordinates = sphere_coordinates(normal),
            .material = sphere.material,
            .offset = surface_offset(std::max(largest(center), radius))};
}

template <typename Number>
Hit<Number> plane_hit(const Plane &plane, const Ray<Number> &ray, Number distance) {
    const Vec<Number> normal(plane.normal), base(plane.point);
    const Vec<Number> near = ray.origin + distance * ray.direction;
    const Vec<Number> point = near - glm::dot(near - base, normal) * normal;
    return {.distance = distance,
            .point = point,
            .shading_normal = normal,
            .geometric_normal = normal,
            .texture_coordinates = {0, 0},
            .material = plane.material,
            .offset = surface_offset(std::max(largest(point), largest(base)))};
}

// `point` of a triangle is put onto the tangent plane of each corner that it is beneath, and the
// three are blended by `weights` (Hanika, Hacking the Shadow Terminator, Ray Tracing Gems II, 2021,
// section 4.3). How far that is, unless it is beneath the facet. Above is where `up` points, the
// facet's normal.
template <typename Number>
Vec<Number> rise_of(const Scene &scene, const Triangle &triangle, const Vec<Number> &weights,
                    const Vec<Number> &point, const Vec<Number> &shading_normal,
                    const Vec<Number> &up) {
    const Number side = glm::dot(shading_normal, up) < 0 ? -1 : 1;
    Vec<Number> blend(0);
    for (int i = 0; i < 3; ++i) {
        const Vertex &corner = scene.vertices[triangle.vertices[std::size_t(i)]];
        const Vec<Number> normal(corner.normal);
        const Number height = glm::dot(point - Vec<Number>(corner.position), normal);
        blend += weights[i] * (side * height < 0 ? point - height * normal : point);
    }
    const Vec<Number> rise = blend - point;
    return glm::dot(rise, up) > 0 ? rise : Vec<Number>(0);
}

// What is said of the corners, blended between them (paper, section 6).
template <typename Number, typename OfVertex>
auto blend_corners(const Scene &scene, const Triangle &triangle, const TriangleHit<Number> &hit,
                   OfVertex of_vertex) {
    const auto at = [&](std::size_t i) { return of_vertex(scene.vertices[triangle.vertices[i]]); };
    return (1 - hit.u - hit.v) * at(0) + hit.u * at(1) + hit.v * at(2);
}

template <typename Number>
Vec2<Number> coordinates_at(const Scene &scene, const Triangle &triangle,
                            const TriangleHit<Number> &hit) {
    return blend_corners(scene, triangle, hit,
                         [](auto &v) { return Vec2<Number>(v.texture_coordinates); });
}

template <typename Number>
Hit<Number> triangle_hit(const Scene &scene, const Triangle &triangle,
                         const TriangleHit<Number> &hit) {
    const auto blend = [&](auto of_vertex) {
        return blend_corners(scene, triangle, hit, of_vertex);
    };
    const Vec<Number> weights(1 - hit.u - hit.v, hit.u, hit.v);
    const Vec<Number> point = blend([](auto &v) { return Vec<Number>(v.position); });
    const auto corners = corners_of<Number>(scene, triangle);
    const auto normal = glm::normalize(blend([](auto &v) { return Vec<Number>(v.normal); }));
    const auto facet = glm::normalize(facing(corners));
    const Vec<Number> geometric = glm::dot(facet, normal) < 0 ? -facet : facet;
    return {
        .distance = hit.distance,
        .point = point,
        .shading_normal = normal,
        .geometric_normal = geometric,
        .texture_coordinates = coordinates_at(scene, triangle, hit),
        .material = triangle.material,
        .offset =
            surface_offset(std::max({largest(corners.a), largest(corners.b), largest(corners.c)})),
        .vertex_color = blend([](auto &v) { return Vec<Number>(v.color); }),
        .rise = rise_of(scene, triangle, weights, point, normal, geometric),
        .rise_behind = rise_of(scene, triangle, weights, point, normal, Vec<Number>(-geometric))};
}

// A surface seen from behind turns both its normals to the eye.
template <typename Number>
Hit<Number> turned_to_eye(Hit<Number> hit, const Vec<Number> &direction) {
    hit.from_behind = glm::dot(hit.geometric_normal, direction) > 0;
    if (hit.from_behind) {
        hit.shading_normal = -hit.shading_normal;
        hit.geometric_normal = -hit.geometric_normal;
        hit.rise = hit.rise_behind;
    }
    return hit;
}

template <typename Number> void record(RayTree &tree, const Hit<Number> &hit) {
    tree.surface = hit.surface;
    tree.from_behind = hit.from_behind;
    tree.point = glm::dvec3(hit.point);
    tree.shading_normal = glm::dvec3(hit.shading_normal);
    tree.geometric_normal = glm::dvec3(hit.geometric_normal);
}

}  // namespace stagelight::reference
