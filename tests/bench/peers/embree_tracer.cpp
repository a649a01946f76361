// SPDX-License-Identifier: MIT
#include "bench/peers/embree_tracer.h"

#include <bit>
#include <limits>
#include <stdexcept>

#include "bench/report.h"
#include "device/device_types.h"

namespace stagelight::bench {
namespace {

constexpr int tile_size = 16;    // pixels, of what a thread takes at once
constexpr int packet_width = 4;  // pixels; as high
constexpr float infinity = std::numeric_limits<float>::infinity();

Vec<float> to_vec(const device::float4 &v) {
    return {v.s[0], v.s[1], v.s[2]};
}
Vec<float> to_vec(const glm::dvec3 &v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// Through the point (x, y) of the picture, of unit length.
template <typename N> Vec<N> direction_at(const device::Camera &camera, const N &x, const N &y) {
    return normalize(all_lanes<N>(to_vec(camera.corner)) + x * all_lanes<N>(to_vec(camera.right))
                     + y * all_lanes<N>(to_vec(camera.down)));
}

template <typename N> N larger(const N &a, const N &b) {
    return a < b ? b : a;
}
template <typename N> N magnitude(const N &v) {
    return larger<N>(v, -v);
}

// From a hit to the light: where the line starts, where it leads, and what light it brings; none
// where the surface is turned away.
template <typename N> struct ShadowLine {
    Vec<N> origin, along;
    N light;
};

// As surface_at and direct_light of kernels/ do it. `facet` and `normal` may have any
// length, `facet` either side.
template <typename N>
ShadowLine<N> line_to(const Vec<N> &light, const Vec<N> &eye, const Vec<N> &direction,
                      const N &distance, Vec<N> facet, Vec<N> normal) {
    const N one = N{} + 1.0F;
    facet = normalize(facet);
    normal = normalize(normal);
    facet = (dot(facet, normal) < 0.0F ? -one : one) * facet;
    const N turn = dot(facet, direction) > 0.0F ? -one : one;
    facet = turn * facet;
    normal = turn * normal;

    const Vec<N> position = eye + distance * direction;
    const Vec<N> to_light = light - position;
    const N square = dot(to_light, to_light);
    const N cosine = dot(normal, to_light) / square_root(square);

    const N size =
        larger<N>(larger<N>(magnitude<N>(eye.x), magnitude<N>(eye.y)), magnitude<N>(eye.z))
        + distance;
    const N side = dot(facet, to_light) < 0.0F ? -one : one;
    const Vec<N> origin = position + (side * 2e-6F * size) * facet;
    return {origin, light - origin, larger<N>(cosine, N{}) / square};
}

template <typename R>
void set_ray(R &ray, const Vec<float> &origin, const Vec<float> &direction, float end) {
    ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
    ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
    ray.tnear = 0, ray.tfar = end, ray.time = 0;
    ray.mask = ~0U, ray.id = 0, ray.flags = 0;
}

// Lanes in an array of Embree's, which are all aligned.
Float16 &lanes(float *array) {
    return *reinterpret_cast<Float16 *>(array);
}
Int16 &lanes(unsigned *array) {
    return *reinterpret_cast<Int16 *>(array);
}

void set_rays(RTCRay16 &rays, const Vec<Float16> &origin, const Vec<Float16> &direction,
              float end) {
    lanes(rays.org_x) = origin.x, lanes(rays.org_y) = origin.y, lanes(rays.org_z) = origin.z;
    lanes(rays.dir_x) = direction.x, lanes(rays.dir_y) = direction.y;
    lanes(rays.dir_z) = direction.z;
    lanes(rays.tnear) = Float16{}, lanes(rays.tfar) = Float16{} + end;
    lanes(rays.time) = Float16{};
    lanes(rays.mask) = Int16{} - 1, lanes(rays.id) = Int16{}, lanes(rays.flags) = Int16{};
}

unsigned count(const Int16 &mask) {
    unsigned result = 0;
    for (int i = 0; i < packet_size; ++i) {
        result += mask[i] != 0;
    }
    return result;
}

RTCIntersectContext context_of(RTCIntersectContextFlags flags) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = flags;
    return context;
}

}  // namespace

EmbreeTracer::EmbreeTracer(const Scene &scene, const EmbreeScene &embree)
    : embree_(embree), camera_(to_single(to_device(scene.camera, scene.width, scene.height))),
      eye_(to_vec(camera_.position)), background_(scene.background) {
    if (scene.lights.size() != 1 || scene.lights[0].type != LightType::point
        || scene.triangles.empty() || scene.width % tile_size != 0
        || scene.height % tile_size != 0) {
        throw std::invalid_argument("not a scene that EmbreeTracer draws");
    }
    const Light &light = scene.lights[0];
    const auto material = static_cast<std::size_t>(scene.triangles[0].material);
    light_ = to_vec(light.position);
    color_ = scene.materials[material].color * light.color * light.intensity;
}

Vec<float> EmbreeTracer::normal_at(unsigned triangle, float u, float v) const {
    const auto &[a, b, c] = embree_.corners(triangle);
    return (1.0F - u - v) * embree_.normal(a) + u * embree_.normal(b) + v * embree_.normal(c);
}

std::uint64_t EmbreeTracer::draw_tile_singly(Image &image, int left, int top) const {
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
    std::uint64_t shadow_rays = 0;
    for (int y = top; y < top + tile_size; ++y) {
        for (int x = left; x < left + tile_size; ++x) {
            const Vec<float> direction =
                direction_at(camera_, static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            RTCRayHit primary;
            set_ray(primary.ray, eye_, direction, infinity);
            primary.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            primary.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(embree_.get(), &context, &primary);
            const RTCHit &hit = primary.hit;
            if (hit.geomID == RTC_INVALID_GEOMETRY_ID) {
                image.at(x, y) = background_;
                continue;
            }
            ShadowLine<float> line =
                line_to(light_, eye_, direction, primary.ray.tfar, {hit.Ng_x, hit.Ng_y, hit.Ng_z},
                        normal_at(hit.primID, hit.u, hit.v));
            if (line.light > 0) {
                RTCRay shadow;
                set_ray(shadow, line.origin, line.along, 1);
                rtcOccluded1(embree_.get(), &context, &shadow);
                ++shadow_rays;
                line.light = shadow.tfar < 0 ? 0 : line.light;
            }
            image.at(x, y) = line.light * color_;
        }
    }
    return shadow_rays;
}

std::uint64_t EmbreeTracer::draw_packet(Image &image, int left, int top) const {
    constexpr Float16 columns{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    constexpr Float16 rows{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
    const auto eye = all_lanes<Float16>(eye_);
    const Vec<Float16> direction =
        direction_at<Float16>(camera_, columns + (static_cast<float>(left) + 0.5F),
                              rows + (static_cast<float>(top) + 0.5F));
    RTCRayHit16 primary;
    set_rays(primary.ray, eye, direction, infinity);
    lanes(primary.hit.geomID) = Int16{} - 1;
    lanes(primary.hit.instID[0]) = Int16{} - 1;
    alignas(64) Int16 valid = Int16{} - 1;
    rtcIntersect16(reinterpret_cast<int *>(&valid), embree_.get(), &context, &primary);

    RTCHit16 &hit = primary.hit;
    const Int16 is_hit = lanes(hit.geomID) != -1;
    Vec<Float16> normal{};
    for (int i = 0; i < packet_size; ++i) {
        if (is_hit[i] != 0) {
            const Vec<float> one = normal_at(hit.primID[i], hit.u[i], hit.v[i]);
            normal.x[i] = one.x, normal.y[i] = one.y, normal.z[i] = one.z;
        }
    }
    ShadowLine<Float16> line =
        line_to<Float16>(all_lanes<Float16>(light_), eye, direction, lanes(primary.ray.tfar),
                         {lanes(hit.Ng_x), lanes(hit.Ng_y), lanes(hit.Ng_z)}, normal);
    valid = is_hit & (line.light > 0.0F);
    const unsigned shadow_rays = count(valid);
    if (shadow_rays > 0) {
        RTCRay16 shadow;
        set_rays(shadow, line.origin, line.along, 1);
        rtcOccluded16(reinterpret_cast<int *>(&valid), embree_.get(), &context, &shadow);
        line.light = lanes(shadow.tfar) < 0.0F ? Float16{} : line.light;
    }
    for (int i = 0; i < packet_size; ++i) {
        image.at(left + i % packet_width, top + i / packet_width) =
            is_hit[i] != 0 ? line.light[i] * color_ : background_;
    }
    return shadow_rays;
}

std::uint64_t EmbreeTracer::draw_tile_in_packets(Image &image, int left, int top) const {
    std::uint64_t shadow_rays = 0;
    for (int y = top; y < top + tile_size; y += packet_width) {
        for (int x = left; x < left + tile_size; x += packet_width) {
            shadow_rays += draw_packet(image, x, y);
        }
    }
    return shadow_rays;
}

EmbreePicture EmbreeTracer::render(EmbreeRays rays, Workers &workers) const {
    EmbreePicture picture;
    picture.image = Image(camera_.size.s[0], camera_.size.s[1]);
    std::atomic<std::uint64_t> shadow_rays = 0;
    const int columns = picture.image.width / tile_size;
    const int tiles = columns * picture.image.height / tile_size;
    const auto draw = [&](int tile) {
        const int left = tile % columns * tile_size;
        const int top = tile / columns * tile_size;
        shadow_rays += rays == EmbreeRays::single ? draw_tile_singly(picture.image, left, top)
                                                  : draw_tile_in_packets(picture.image, left, top);
    };
    picture.milliseconds = time_of([&] { workers.run(tiles, draw); });
    picture.shadow_rays = shadow_rays;
    return picture;
}

}  // namespace stagelight::bench
