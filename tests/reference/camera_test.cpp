// SPDX-License-Identifier: MIT
#include "reference/camera.h"

#include "reference/view.h"
#include "scenes.h"

namespace stagelight::reference {
namespace {

dvec3 direction(const CameraDescription &camera, double x, double y) {
    return primary_ray(camera, 4, 2, x, y).direction;
}

// At a fov of 90° half the picture's width is tan 45° = 1 at the distance 1; its height, of
// half as many pixels, is 1/2. The camera looks along -z, so the upper left corner lies at
// (-1, 1/2, -1), and so on round.
TEST(ReferenceStage01Camera, CornersAndCentreLieWhereTheFovPutsThem) {
    const CameraDescription camera{.fov = 90};
    expect_near(direction(camera, 0, 0), dvec3(-1, 0.5, -1) / 1.5, 1e-15);
    expect_near(direction(camera, 4, 0), dvec3(1, 0.5, -1) / 1.5, 1e-15);
    expect_near(direction(camera, 0, 2), dvec3(-1, -0.5, -1) / 1.5, 1e-15);
    expect_near(direction(camera, 4, 2), dvec3(1, -0.5, -1) / 1.5, 1e-15);
    expect_near(direction(camera, 2, 1), dvec3(0, 0, -1), 1e-15);
}

// However the camera is turned: the whole angle between the middles of the left and the right
// border is the fov, they lie level (up points out of their plane's side), and the centre
// looks at look_at.
TEST(ReferenceStage01Camera, TheFovIsTheWholeHorizontalAngle) {
    const CameraDescription camera{
        .position = {3, 2, 5}, .look_at = {-1, 0.5, 1}, .up = {0.1, 1, 0}, .fov = 37};
    const dvec3 left = direction(camera, 0, 1), right = direction(camera, 4, 1);
    EXPECT_NEAR(glm::degrees(std::acos(glm::dot(left, right))), 37, 1e-12);
    EXPECT_NEAR(glm::dot(glm::normalize(right - left), camera.up), 0, 1e-15);
    expect_near(direction(camera, 2, 1), glm::normalize(dvec3(-4, -1.5, -4)), 1e-15);
    EXPECT_GT(glm::dot(direction(camera, 2, 0), camera.up),
              glm::dot(direction(camera, 2, 2), camera.up));
}

// A wall across the view at the distance 3 ½ has N = +z: (½, ½, 1). Halfway between two units the
// contour is at its strongest, 1 - 0.2 / (1 + 3.5² / 50); at a whole unit there is none.
TEST(ReferenceStage01View, ShowsNormalsWithAContourEachUnit) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    add_plane(scene, {0, 0, 1}, {0, 0, -3.5}, {});
    const World<double> world(scene);
    RayTree tree;
    const auto shown = [&](double z, double toward) {
        return normals_and_distances(world, ray({0, 0, z}, {0, 0, toward}), tree);
    };
    expect_near(shown(0, -1), (1 - 0.2 / 1.245) * dvec3(0.5, 0.5, 1), 1e-15);
    expect_near(shown(0.5, -1), {0.5, 0.5, 1}, 1e-15);
    // From behind, the normal is turned to the eye.
    expect_near(shown(-5.5, 1), {0.5, 0.5, 0}, 1e-15);
    expect_near(shown(0, 1), scene.background, 0);
}

}  // namespace
}  // namespace stagelight::reference
