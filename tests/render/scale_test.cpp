// SPDX-License-Identifier: MIT
// The same scene a thousand times smaller or larger, or far from the origin, is the same picture.
#include "image/compare.h"
#include "reference/reference.h"
#include "render/on_each_device.h"
#include "scene/scene_file.h"

namespace stagelight::render {
namespace {

// Every point through `place`; all else by the factor that lengths are multiplied by.
template <typename Place> Scene moved(Scene scene, double scale, Place place) {
    const auto move = [&](dvec3 &point) { point = place(point); };
    move(scene.camera.position);
    move(scene.camera.look_at);
    for (Sphere &sphere : scene.spheres) {
        move(sphere.center);
        sphere.radius *= scale;
    }
    for (Plane &plane : scene.planes) {
        move(plane.point);
    }
    for (Vertex &vertex : scene.vertices) {
        move(vertex.position);
    }
    for (Light &light : scene.lights) {
        move(light.position);
        light.range *= scale;
        light.intensity *= light.type == LightType::point ? scale * scale : 1;
    }
    for (Material &material : scene.materials) {
        material.absorption /= scale;
    }
    return scene;
}

Scene scaled(const Scene &scene, double scale) {
    return moved(scene, scale, [scale](dvec3 point) { return scale * point; });
}

Scene shifted(const Scene &scene, dvec3 offset) {
    return moved(scene, 1, [offset](dvec3 point) { return point + offset; });
}

class OfAnySize : public OnEachDevice {
protected:
    static void expect_same_pictures(const char *stage) {
        Scene scene = load_scene(std::string(STAGELIGHT_SOURCE_DIR) + "/scenes/" + stage + ".toml");
        scene.width = 96;
        scene.height = 58;
        const auto edge =
            reference::render<double>(scene, {scene.width, scene.height, scene.max_depth, {}}).edge;
        const Image picture = draw(stage, scene).image;
        const auto with = [&](const Scene &other) {
            return compare(draw(stage, other).image, picture, edge, {});
        };
        for (const double scale : {0.001, 1000.0}) {
            const Comparison comparison = with(scaled(scene, scale));
            EXPECT_EQ(comparison.failure, "") << scale << ": " << to_string(comparison);
        }
        // There a float is 2^-17 of a unit from the next: an edge may fall on its other side.
        const Comparison far = with(shifted(scene, {100, 50, -80}));
        EXPECT_EQ(far.interior_outliers, 0) << to_string(far);
        EXPECT_LE(far.edge_outliers + far.strays, 96 * 58 / 200) << to_string(far);
        EXPECT_LE(std::abs(far.mean_signed_error), Tolerance{}.mean_signed_error);
    }
};

class Stage04Scale : public OfAnySize {};
class Stage05Scale : public OfAnySize {};
INSTANTIATE_TEST_SUITE_P(Devices, Stage04Scale, each_device(), device_name);
INSTANTIATE_TEST_SUITE_P(Devices, Stage05Scale, each_device(), device_name);

TEST_P(Stage04Scale, LeavesGlassAndMirrorsAsTheyAre) {
    expect_same_pictures("04_refraction_beer");
}

TEST_P(Stage05Scale, LeavesSuzanneAndHerShadowAsTheyAre) {
    expect_same_pictures("05_meshes");
}

}  // namespace
}  // namespace stagelight::render
