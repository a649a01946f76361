// SPDX-License-Identifier: MIT
// Where rays start: at the camera, and off surfaces.
#include "reference/camera.h"

#include <cmath>

#include "device/device_types.h"
#include "kernels/on_device.h"
#include "kernels/worst.h"
#include "reference/scenes.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;

using KernelsStage01Camera = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage01Camera, each_device(), device_name);

struct RayOut {
    vec4 origin, direction;
};

// Cameras of all angles, far from the origin and turned at random.
CameraDescription random_camera(Dice &dice) {
    const dvec3 position = dice.in_cube(std::pow(10, dice.between(-3, 6)));
    const dvec3 forward = std::pow(10, dice.between(-1, 3)) * dice.direction();
    const dvec3 sideways = glm::cross(forward, dice.direction());
    return {.position = position,
            .look_at = position + forward,
            .up = glm::normalize(glm::cross(sideways, forward)) + dice.between(-2, 2) * forward,
            .fov = dice.between(0.1, 179.5)};
}

// Of each picture its corners, some pixels of its inside, and sample points that are not the
// centre, against the formula of docs/shading.md in double.
TEST_P(KernelsStage01Camera, RaysMatchDouble) {
    Dice dice;
    std::vector<device::Camera> cameras;
    std::vector<device::int2> pixels;
    std::vector<dvec3> positions, directions;
    std::vector<double> widths;
    for (int i = 0; i < 512; ++i) {
        const CameraDescription camera = random_camera(dice);
        const int w = int(std::pow(2, dice.between(0, 14))),
                  h = int(std::pow(2, dice.between(0, 14)));
        const device::float2 sample = {{float(dice.between(0, 1)), float(dice.between(0, 1))}};
        const int x = int(dice.between(0, w - 1)), y = int(dice.between(0, h - 1));
        for (const auto &[column, row] :
             {std::pair{0, 0}, {w - 1, 0}, {0, h - 1}, {w - 1, h - 1}, {w / 2, h / 2}, {x, y}}) {
            cameras.push_back(to_single(to_device(camera, w, h)));
            if (i % 2 == 1) {
                cameras.back().sample = sample;
            }
            const auto [sample_x, sample_y] = cameras.back().sample.s;
            pixels.push_back({{column, row}});
            const auto ray = reference::primary_ray<double>(camera, w, h, column + double(sample_x),
                                                            row + double(sample_y));
            positions.push_back(ray.origin);
            directions.push_back(ray.direction);
            // The view's corner in units of its middle: what is rounded on the way there.
            widths.push_back(std::tan(glm::radians(camera.fov) / 2) * std::hypot(1, double(h) / w));
        }
    }
    const auto rays = build("primitives.cl").run<RayOut>("camera_rays", cameras, pixels);
    Worst origin("origin"), direction("direction"), length("length");
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const dvec3 is(rays[i].direction);
        origin.compare(i, dvec3(rays[i].origin), positions[i], ulp * glm::length(positions[i]));
        direction.compare(i, is, directions[i], 2 * ulp * (1 + widths[i]));
        length.compare(i, glm::length(is), 1, 2 * ulp);  // OpenCL C's normalize
    }
    origin.expect(3000);
    direction.expect(3000);
    length.expect(3000);
}

using KernelsStage01Offset = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage01Offset, each_device(), device_name);

// A ray starts off the surface on the side that it goes to, by at most 4e-6 of the size of the
// coordinates (docs/shading.md), and by at least 1e-6, 8 ulp: more than they are rounded by.
TEST_P(KernelsStage01Offset, RaysStartOffTheSurfaceOnTheirSide) {
    Dice dice;
    std::vector<vec4> origins, directions, normals;
    std::vector<float> distances;
    for (int i = 0; i < 4096; ++i) {
        const double scale = std::pow(10, dice.between(-6, 6));
        origins.emplace_back(vec3(scale * dice.in_cube(1)), 0);
        const double length = std::pow(10, dice.between(-2, 2));  // need not be 1
        directions.emplace_back(vec3(dice.direction()) * float(i % 2 == 0 ? 1 : length), 0);
        normals.emplace_back(vec3(dice.direction()), 0);
        distances.push_back(float(scale * std::pow(10, dice.between(-3, 3))));
    }
    const auto results = build("primitives.cl", {}, {{"origin", "scaled"}})
                             .run<vec4>("origins_off", origins, directions, normals, distances);
    Worst offset("offset over size of coordinates"), along("way along the normal");
    for (std::size_t i = 0; i < results.size(); ++i) {
        const dvec3 origin(origins[i]), direction(directions[i]), normal(normals[i]);
        const double distance = distances[i];
        const dvec3 point = origin + distance * direction;
        const double size = std::max(reference::largest(origin), distance);
        offset.compare(i, results[i].w / size, 2.5e-6, 1.5e-6);
        const double side = glm::dot(direction, normal) < 0 ? -1 : 1;
        // The point itself is rounded where it was worked out, and where it is moved.
        const double rounding =
            2 * ulp * (reference::largest(origin) + distance * glm::length(direction));
        along.compare(i, glm::dot(dvec3(results[i]) - point, normal), side * results[i].w,
                      rounding);
    }
    offset.expect(4096);
    along.expect(4096);
}

}  // namespace
}  // namespace stagelight
