// SPDX-License-Identifier: MIT
// The closest hits of rays in random scenes, against the reference in double.
#include "kernels/certain.h"
#include "kernels/on_device.h"
#include "kernels/random_scene.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec3, glm::vec4;
using reference::Dice;

using KernelsStage01Scene = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage01Scene, each_device(), device_name);
using KernelsStage05Scene = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage05Scene, each_device(), device_name);

// A struct of scene.cl.
struct Found {
    vec4 position, normal, geometric_normal;
    glm::vec2 texture_coordinates;
    int shape, material;
};

class SurfaceComparison {
public:
    // Without textures a surface has no coordinates.
    explicit SurfaceComparison(bool with_textures) : with_textures_(with_textures) {}

    void compare(std::size_t i, const Found &found, const std::vector<Hit> &hits) {
        const Hit &hit = hits[0];
        material_.compare(i, found.material, hit.material, 0);
        behind_.compare(i, found.geometric_normal.w, hit.from_behind, 0);
        if (found.material != hit.material) {
            return;
        }
        const auto check = [&](Worst &worst, const auto &is, const auto &value, double least) {
            worst.compare(i, is, value(hit), tolerance_of(hits, value, least));
        };
        check(
            distance_, found.position.w, [](const Hit &h) { return h.distance; }, rounding);
        check(
            position_, dvec3(found.position), [](const Hit &h) { return h.point; },
            rounding + ulp * hit.distance);
        check(
            normal_, dvec3(found.normal), [](const Hit &h) { return h.shading_normal; }, 4 * ulp);
        check(
            geometric_, dvec3(found.geometric_normal),
            [](const Hit &h) { return h.geometric_normal; }, 4 * ulp);
        const auto coordinates = [](const Hit &h) { return dvec3(h.texture_coordinates, 0); };
        // Across a sphere's seam u jumps from 1 to 0.
        const double tolerance = tolerance_of(hits, coordinates, 16 * ulp);
        if (with_textures_ && tolerance < 0.5 * share_of_spread) {
            coordinates_.compare(i, dvec3(found.texture_coordinates, 0), coordinates(hit),
                                 tolerance);
        }
    }
    void expect(std::size_t least) const {
        coordinates_.expect(with_textures_ ? least : 0);
        for (const Worst *worst :
             {&material_, &behind_, &distance_, &position_, &normal_, &geometric_}) {
            worst->expect(least);
        }
    }

private:
    bool with_textures_;
    Worst material_{"which shape"}, behind_{"from behind"}, distance_{"distance"},
        position_{"position"}, normal_{"normal"}, geometric_{"geometric normal"},
        coordinates_{"texture coordinates"};
};

// Six scenes through one program, which knows only what all of them have.
void expect_closest_hits(DeviceProgram program, const RandomScene &with) {
    Dice dice;
    SurfaceComparison comparison(with.triangles);
    Worst misses("misses");
    for (int i = 0; i < 6; ++i) {
        const Scene scene = random_scene(dice, with);
        const World world(scene);
        const RandomWays rays(dice, RandomWays::rays);
        const auto found = program.run_in<Found>(scene, "closest", rays.origins, rays.ends);
        for (std::size_t j = 0; j < found.size(); ++j) {
            const auto hits = certain_hits(world, rays.ray(j));
            if (!hits.empty()) {
                comparison.compare(j, found[j], hits);
            } else if (certainly_blocked(world, rays.ray(j)) == false) {
                misses.compare(j, found[j].position.w, INFINITY, 0);
            }
        }
    }
    comparison.expect(4000);
    misses.expect(1000);
}

TEST_P(KernelsStage01Scene, ClosestHitsMatchTheReference) {
    const RandomScene with{};
    expect_closest_hits(build("scene.cl", needs_for(with, 1)), with);
}

TEST_P(KernelsStage05Scene, TrianglesAmongAllElseMatchTheReference) {
    const RandomScene with{.triangles = true};
    expect_closest_hits(build("scene.cl", needs_for(with, 6)), with);
}

// The distance from afar is rounded by up to hundredths of a radius, but a hit's point is put
// back onto the sphere, so that rays from there start on the right side.
TEST_P(KernelsStage01Scene, PointsOfFarSpheresLieOnThem) {
    Scene scene;
    reference::add_sphere(scene, {1, 2, 3}, 1, {});
    Dice dice;
    RandomWays rays(dice, RandomWays::rays);
    for (std::size_t i = 0; i < rays.origins.size(); ++i) {
        const double away = std::pow(10, dice.between(2, 5));
        const dvec3 target = scene.spheres[0].center + dice.between(0, 0.5) * dice.direction();
        rays.origins[i] = vec4(vec3(target - away * dvec3(rays.ends[i])), 0);
    }
    const auto found = build("scene.cl", needs_of(scene, 1, 8))
                           .run_in<Found>(scene, "closest", rays.origins, rays.ends);
    Worst radius("distance from the centre");
    for (std::size_t i = 0; i < found.size(); ++i) {
        radius.compare(i, glm::distance(dvec3(found[i].position), scene.spheres[0].center), 1,
                       2 * ulp * 4);  // coordinates of up to 4
    }
    radius.expect(1024);
}

}  // namespace
}  // namespace stagelight
