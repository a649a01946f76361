// SPDX-License-Identifier: MIT
// What stands in the way in random scenes, and the light that comes through, against the
// reference in double.
#include "kernels/certain.h"
#include "kernels/on_device.h"
#include "kernels/random_scene.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec4;
using reference::Dice;

using KernelsStage02Shadow = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage02Shadow, each_device(), device_name);
using KernelsStage05Shadow = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage05Shadow, each_device(), device_name);

// Six scenes through one program, which knows only what all of them have.
constexpr int scenes = 6;

void expect_any_hits(DeviceProgram &program, const RandomScene &with) {
    Dice dice;
    Worst any_ray("any hit of a ray"), any_line("any hit of a line");
    for (int i = 0; i < scenes; ++i) {
        const Scene scene = random_scene(dice, with);
        const World world(scene);
        const RandomWays rays(dice, RandomWays::rays), lines(dice, RandomWays::lines);
        const auto by_ray = program.run_in<int>(scene, "any_ray", rays.origins, rays.ends);
        const auto by_line = program.run_in<int>(scene, "any_line", lines.origins, lines.ends);
        for (std::size_t j = 0; j < by_ray.size(); ++j) {
            if (const auto blocked = certainly_blocked(world, rays.ray(j))) {
                any_ray.compare(j, by_ray[j], *blocked, 0);
            }
            if (const auto blocked = certainly_blocked(world, lines.line(j))) {
                any_line.compare(j, by_line[j], *blocked, 0);
            }
        }
    }
    any_ray.expect(5000);
    any_line.expect(5000);
}

void expect_direct_light(DeviceProgram &program, const RandomScene &with) {
    Dice dice;
    Worst light("direct light"), shadow_rays("shadow rays");
    for (int i = 0; i < scenes; ++i) {
        const Scene scene = random_scene(dice, with);
        const World world(scene);
        const RandomWays rays(dice, RandomWays::rays);
        const auto direct = program.run_in<vec4>(scene, "direct", rays.origins, rays.ends);
        for (std::size_t j = 0; j < direct.size(); ++j) {
            const auto hits = certain_hits(world, rays.ray(j));
            const auto lit = hits.empty() ? std::nullopt : certain_light(world, hits);
            if (lit) {
                light.compare(j, dvec3(direct[j]), lit->sum, lit->tolerance);
                shadow_rays.compare(j, direct[j].w, lit->shadow_rays, 0);
            }
        }
    }
    light.expect(3000);
    shadow_rays.expect(3000);
}

TEST_P(KernelsStage02Shadow, ShadowsAndDirectLightMatchTheReference) {
    const RandomScene with{.point_lights = true, .directional_light = true};
    DeviceProgram program = build("scene.cl", needs_for(with, 2));
    expect_any_hits(program, with);
    expect_direct_light(program, with);
}

// A kernel knows only the kinds of lights that a scene has.
TEST_P(KernelsStage02Shadow, LightsOfOneKindOrNoneDoAsWell) {
    for (const RandomScene &with :
         {RandomScene{.point_lights = true}, {.directional_light = true}, {}}) {
        DeviceProgram program = build("scene.cl", needs_for(with, 2));
        expect_direct_light(program, with);
    }
}

TEST_P(KernelsStage05Shadow, TrianglesCastThemToo) {
    const RandomScene with{.triangles = true, .point_lights = true, .directional_light = true};
    DeviceProgram program = build("scene.cl", needs_for(with, 6));
    expect_any_hits(program, with);
    expect_direct_light(program, with);
}

}  // namespace
}  // namespace stagelight
