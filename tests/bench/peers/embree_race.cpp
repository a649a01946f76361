// SPDX-License-Identifier: MIT
#include "bench/peers/embree_race.h"

#include <fmt/format.h>

#include "bench/contest.h"
#include "bench/peers/embree_tracer.h"
#include "bench/stages.h"
#include "device/bvh.h"
#include "device/renderer.h"

namespace stagelight::bench {
namespace {

constexpr int rounds = 15;
constexpr int builds = 3;

EmbreeScene build_embree(const Scene &scene, RTCBuildQuality quality, double &milliseconds) {
    std::vector<double> times;
    for (int i = 1; i < builds; ++i) {
        times.push_back(EmbreeScene(scene, quality).build_milliseconds());
    }
    EmbreeScene embree(scene, quality);
    times.push_back(embree.build_milliseconds());
    milliseconds = median(times);
    return embree;
}

// The full tracer first: the others are measured by it.
std::vector<Contestant> contestants_of(Renderer &renderer, const EmbreeTracer &high,
                                       const EmbreeTracer &medium, Workers &workers) {
    std::vector<Contestant> contestants{ours(renderer, full_tracer())};
    const auto add = [&](const std::string &name, const EmbreeTracer &tracer, EmbreeRays rays) {
        contestants.push_back({name, [&tracer, &workers, rays] {
                                   EmbreePicture picture = tracer.render(rays, workers);
                                   const std::uint64_t primary = picture.image.pixels.size();
                                   return Drawn{std::move(picture.image),
                                                primary + picture.shadow_rays,
                                                picture.milliseconds};
                               }});
    };
    add("Embree, single, high", high, EmbreeRays::single);
    add("Embree, 16 wide, high", high, EmbreeRays::packet);
    add("Embree, single, medium", medium, EmbreeRays::single);
    add("Embree, 16 wide, medium", medium, EmbreeRays::packet);
    return contestants;
}

}  // namespace

bool race_embree(const cl::Device &device, const std::string &name, const Scene &scene,
                 Workers &workers, ordered_json &report) {
    say(fmt::format("{}: trees over {} triangles", name, scene.triangles.size()));
    const double our_build = median_time_of(builds, [&] { build_bvh(scene); });
    double high_build = 0;
    double medium_build = 0;
    const EmbreeScene high = build_embree(scene, RTC_BUILD_QUALITY_HIGH, high_build);
    const EmbreeScene medium = build_embree(scene, RTC_BUILD_QUALITY_MEDIUM, medium_build);
    const EmbreeTracer high_tracer(scene, high);
    const EmbreeTracer medium_tracer(scene, medium);
    // EmbreeTracer's shadows are those of facets.
    const RenderSettings settings = settings_of(full_tracer(), scene, {{"terminator", "none"}});
    Renderer renderer(device, full_tracer(), scene, settings);

    say(name + ": the reference, to hold all pictures to");
    std::vector<Contestant> contestants =
        contestants_of(renderer, high_tracer, medium_tracer, workers);
    if (!agree(contestants, reference_of(full_tracer(), scene, settings))) {
        return false;
    }
    say(fmt::format("{}: {} rounds", name, rounds));
    time_in_turn(contestants, rounds);

    fmt::print("\n{}: {} triangles, {}x{}, {} rays, {} threads, {}\n{}", name,
               scene.triangles.size(), scene.width, scene.height, contestants.front().rays,
               workers.size(), high.description(), table_of(contestants));
    fmt::print("tree built in {:.1f} ms; Embree's: high quality {:.1f} ms, medium {:.1f} ms\n",
               our_build, high_build, medium_build);
    report[name] = {{"triangles", scene.triangles.size()},
                    {"size", {scene.width, scene.height}},
                    {"threads", workers.size()},
                    {"embree", high.description()},
                    {"build_milliseconds",
                     {{"ours", our_build}, {"high", high_build}, {"medium", medium_build}}},
                    {"tracers", json_of(contestants)}};
    return true;
}

}  // namespace stagelight::bench
