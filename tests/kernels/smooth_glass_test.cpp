// SPDX-License-Identifier: MIT
// What a ray meets on a smooth mesh of glass, whose shading normal leans away from its facet's.
#include "kernels/glass.h"

namespace stagelight {
namespace {

using glm::dvec3, glm::vec2, glm::vec3, glm::vec4;

using KernelsStage11SmoothGlass = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage11SmoothGlass, each_device(), device_name);

const SceneNeeds with_glass_mesh{{"HAS_DIELECTRIC", 1},
                                 {"HAS_DIELECTRIC_MESH", 1},
                                 {"MAX_DEPTH", glass_max_depth},
                                 {"STACK_SIZE", glass_max_depth + 1}};

// Rays that face the facet, and shading normals on its side: in every fourth case the ray runs
// almost along the shading normal's plane.
struct LeaningNormals {
    std::vector<vec4> directions, normals, facets;
    std::vector<vec2> media;  // index of refraction, from behind

    LeaningNormals() {
        reference::Dice dice;
        for (int i = 0; i < 8192; ++i) {
            const dvec3 facet = dice.direction();
            const dvec3 normal = direction_at(dice, -facet, dice.between(0.1, 1));
            const double cosine = i % 4 == 0 ? std::pow(10, dice.between(-5, -2)) : 0;
            dvec3 direction = dice.direction();
            if (i % 4 == 0) {
                direction = direction_at(dice, normal, i % 8 == 0 ? cosine : -cosine);
            }
            if (glm::dot(direction, facet) > 0) {
                direction = -direction;
            }
            directions.emplace_back(vec3(direction), 0);
            normals.emplace_back(vec3(normal), 0);
            facets.emplace_back(vec3(facet), 0);
            media.emplace_back(float(dice.between(0.5, 2.5)), i % 2);
        }
    }
};

TEST_P(KernelsStage11SmoothGlass, InterfacesMatchDouble) {
    const LeaningNormals cases;
    const auto results = build("optics.cl", with_glass_mesh)
                             .run<vec4>("smooth_interfaces", cases.directions, cases.normals,
                                        cases.facets, cases.media);
    Worst reflectance("reflectance"), direction("refracted direction"), side("side of the facet");
    std::size_t turned_away = 0, folded = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const dvec3 d = unit(cases.directions[i]), n = unit(cases.normals[i]),
                    g = unit(cases.facets[i]);
        const double ior = cases.media[i].x, cosine = -glm::dot(d, n);
        const double n1 = cases.media[i].y > 0 ? ior : 1, n2 = cases.media[i].y > 0 ? 1 : ior;
        const Snell snell(d, n, n1 / n2);
        if (!snell.certain || std::abs(cosine) < 4 * ulp) {
            continue;
        }
        const auto truth = cosine > 0 ? reference::refract(d, n, n1, n2) : std::nullopt;
        const double share = truth ? reference::schlick(n1, n2, cosine, truth->cosine) : 1;
        const double rounding = 2 * ulp * (1 + n1 / n2) + snell.cosine_rounding;
        reflectance.compare(i, results[i].w, share, truth ? 4 * ulp + 5 * rounding : 0);
        turned_away += cosine < 0;
        if (truth) {
            const dvec3 refracted(results[i]);
            direction.compare(i, refracted, reference::beneath(truth->direction, g), 4 * rounding);
            side.compare(i, std::max(0.0, glm::dot(refracted, g)), 0, 2 * ulp);
            folded += glm::dot(truth->direction, g) > 1e-3;
        }
    }
    reflectance.expect(7900);
    direction.expect(3000);
    side.expect(3000);
    EXPECT_GT(turned_away, 1000u);
    EXPECT_GT(folded, 50u);
}

}  // namespace
}  // namespace stagelight
