// SPDX-License-Identifier: MIT
// Mirrors and glossy surfaces.
#include "scenes.h"

namespace stagelight::reference {
namespace {

// Two mirrors at a right angle, x = 0 and z = 0, turn (x, y, z) into (-x, y, -z) together. The
// ray o + t d, seen in them, goes on as (-x, y, -z) of that: antiparallel but for y. It meets
// the wall z = 5 where -(o.z + t d.z) = 5.
TEST(ReferenceStage03Mirror, ACornerSendsTheRayBack) {
    const dvec3 o(2, 0.5, 4), d = glm::normalize(dvec3(-1, 0.25, -1.5));
    const double t = (-5 - o.z) / d.z;
    const dvec3 end(-(o.x + t * d.x), o.y + t * d.y, 5);
    const dvec3 red(0.9, 0.3, 0.3), green(0.3, 0.8, 0.4), white(0.7, 0.6, 0.5);
    Scene scene;
    add_plane(scene, {1, 0, 0}, {0, 0, 0}, mirror(red));
    add_plane(scene, {0, 0, 1}, {0, 0, 0}, mirror(green));
    add_plane(scene, {0, 0, -1}, {0, 0, 5}, diffuse(white));
    add_point_light(scene, end - dvec3(0, 0, 1), {1, 1, 1}, 3);  // at 1 before the wall: E = 3
    const RayTree tree = met(scene, ray(o, d));
    ASSERT_EQ(tree.children.size(), 1u);
    ASSERT_EQ(tree.children[0].children.size(), 1u);
    expect_near(tree.children[0].children[0].point, end, 1e-12);
    expect_near(seen(scene, ray(o, d)), red * green * white * 3.0, 1e-12);
}

// A light halfway between two glossy walls, 1 before each, gives both E = I. Of a ray straight
// at one, hit number k adds (1 - s) c I (s c)^k, for k = 0 … max_depth: the geometric sum
// (1 - s) c I (1 - q^(max_depth + 1)) / (1 - q) with q = s c.
TEST(ReferenceStage03Glossy, FacingWallsMakeAGeometricSum) {
    const dvec3 c(0.95, 0.8, 0.5);
    const double s = 0.75, I = 2;
    Scene scene;
    add_plane(scene, {0, 0, 1}, {0, 0, -1}, glossy(c, s));
    add_plane(scene, {0, 0, -1}, {0, 0, 1}, glossy(c, s));
    add_point_light(scene, {0, 0, 0}, {1, 1, 1}, I);
    for (const int max_depth : {0, 1, 2, 8, 64}) {
        const dvec3 q = s * c;
        const dvec3 sum = (1.0 - glm::pow(q, dvec3(max_depth + 1))) / (1.0 - q);
        expect_near(seen(scene, ray({0, 0, 0.5}, {0, 0, -1}), {.max_depth = max_depth}),
                    (1 - s) * c * I * sum, 1e-12);
    }
}

// (1 - s) c E + s c b, from all diffuse to all mirror.
TEST(ReferenceStage03Glossy, BlendsDiffuseAndReflected) {
    const dvec3 c(0.9, 0.5, 0.2), b(0.3, 0.6, 0.9);
    for (const double s : {0.0, 0.25, 1.0}) {
        Scene scene;
        scene.background = b;
        add_plane(scene, {0, 1, 0}, {0, 0, 0}, glossy(c, s));
        add_directional_light(scene, {0, -1, 0}, {1, 1, 1}, 2);
        expect_near(seen(scene, ray({0, 1, 0}, {1, -1, 0})), (1 - s) * c * 2.0 + s * c * b, 1e-14);
    }
}

TEST(ReferenceStage03Mirror, RaysBeyondTheDepthAddNothing) {
    Scene scene;
    scene.background = {1, 1, 1};
    add_plane(scene, {0, 1, 0}, {0, 0, 0}, mirror({1, 1, 1}));
    expect_near(seen(scene, ray({0, 1, 0}, {1, -1, 0}), {.max_depth = 1}), {1, 1, 1}, 0);
    expect_near(seen(scene, ray({0, 1, 0}, {1, -1, 0}), {.max_depth = 0}), {0, 0, 0}, 0);
}

// d = (1, -1, 0)/√2 off a normal that leans by 30° along the ray leaves at 15° *below* the floor;
// folded back it leaves at 15° above.
TEST(ReferenceStage03Mirror, ARayThatDivesBeneathTheFacetIsFoldedBack) {
    const double r15 = glm::radians(15.0);
    const dvec3 d = glm::normalize(dvec3(1, -1, 0)), facet(0, 1, 0);
    const dvec3 leaned(std::sin(glm::radians(30.0)), std::cos(glm::radians(30.0)), 0);
    expect_near(reflect(d, facet, facet), glm::normalize(dvec3(1, 1, 0)), 1e-15);
    expect_near(reflect(d, leaned, facet), {std::cos(r15), std::sin(r15), 0}, 1e-15);
}

}  // namespace
}  // namespace stagelight::reference
