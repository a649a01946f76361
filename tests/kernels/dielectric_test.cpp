// SPDX-License-Identifier: MIT
// What a ray meets at the surface of glass, and the rays that it spawns there.
#include "kernels/glass_spheres.h"

namespace stagelight {
namespace {

using KernelsStage04Dielectric = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage04Dielectric, each_device(), device_name);

TEST_P(KernelsStage04Dielectric, InterfacesMatchDouble) {
    const GlassSpheres cases;
    const auto results = build("optics.cl", with_glass)
                             .run<vec4>("interfaces", cases.directions, cases.normals, cases.iors);
    Worst reflectance("reflectance"), direction("refracted direction");
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Truth truth(cases, i);
        if (truth.certain) {
            reflectance.compare(i, results[i].w, truth.reflectance,
                                truth.refraction ? truth.reflectance_rounding : 0);
            if (truth.refraction) {
                direction.compare(i, dvec3(results[i]), truth.refraction->direction,
                                  truth.direction_rounding);
            }
        }
    }
    reflectance.expect(4000);
    direction.expect(2200);
}

TEST_P(KernelsStage04Dielectric, EveryWallReflectsAndRefracts) {
    const GlassSpheres cases;
    const auto results = spawn(build("optics.cl", with_glass), cases);
    RayComparison reflected("reflected"), refracted("refracted");
    Worst side("side that a ray starts on"), counted("ray counts");
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Truth truth(cases, i);
        if (!truth.certain) {
            continue;
        }
        const dvec3 n = unit(cases.normals[i]), point(cases.points[i]);
        const auto &[reflection, refraction] = results[i].rays;
        ASSERT_TRUE(reflection.exists()) << "case " << i;
        ASSERT_EQ(refraction.exists(), truth.refraction.has_value()) << "case " << i;
        counted.compare(i, dvec3(results[i].counts), {1, refraction.exists(), 0}, 0);
        reflected.compare(i, reflection, truth.reflectance, truth.reflectance_rounding,
                          reference::reflect(unit(cases.directions[i]), n, n), 8 * ulp,
                          same_medium);
        side.compare(i, glm::dot(dvec3(reflection.origin) - point, n) > 0, true, 0);
        if (truth.refraction) {
            refracted.compare(i, refraction, 1 - truth.reflectance, truth.reflectance_rounding,
                              truth.refraction->direction, truth.direction_rounding,
                              cases.behind(i) ? air : dvec3(cases.absorptions[i]));
            side.compare(i, glm::dot(dvec3(refraction.origin) - point, n) < 0, true, 0);
        }
    }
    reflected.expect(4000);
    refracted.expect(2200);
    side.expect(6200);
    counted.expect(4000);
}

TEST_P(KernelsStage04Dielectric, RaysBeyondTheDepthAreCountedAsDropped) {
    GlassSpheres cases;
    for (vec4 &medium : cases.media) {
        medium.z = glass_max_depth;
    }
    for (const Methods &method : {Methods{}, interior_paper}) {
        const auto results = spawn(build("optics.cl", with_glass, method), cases);
        Worst counted("ray counts"), kept("rays on the stack");
        for (std::size_t i = 0; i < results.size(); i += 2) {
            counted.compare(i, dvec3(results[i].counts), {0, 0, 2}, 0);
            kept.compare(i, results[i].rays[0].exists(), false, 0);
        }
        counted.expect(2048);
        kept.expect(2048);
    }
}

}  // namespace
}  // namespace stagelight
