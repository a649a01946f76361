// SPDX-License-Identifier: MIT
// Stage 11: where light ends on a coarse mesh that stands for a ball. The truth is the ball.
#include <cmath>

#include "device/methods.h"
#include "reference/reference.h"
#include "render/coarse_ball.h"

namespace stagelight::render {
namespace {

class Stage11Terminator : public OnEachDevice {
protected:
    static Frame draw_by(const char *method, const Scene &scene, const char *width = "1") {
        return renderer("11_full_tracer", scene, by_terminator(method, scene, width)).render();
    }
};
INSTANTIATE_TEST_SUITE_P(Devices, Stage11Terminator, each_device(), device_name);

constexpr int rows = 8;  // of facets
const dvec3 white(1, 1, 1);

// What is left is that the normals are blended along chords: 0.008. By `none` facets that are
// turned away are black up to where the cosine is 0.13; by `chiang` they are too, and their
// neighbours fade.
TEST_P(Stage11Terminator, IsTheBallsByHanika) {
    const Scene scene = coarse_ball(rows);
    const auto off = [&](const char *method) {
        return OffTheBall(draw_by(method, scene).image, scene);
    };
    EXPECT_LT(off("hanika").rms, 0.0085);
    EXPECT_EQ(off("hanika").black, 0);
    EXPECT_GT(off("none").rms, 0.0105);
    EXPECT_GT(off("none").black, 100);
    EXPECT_GT(off("chiang").rms, 0.03);
    EXPECT_EQ(off("chiang").black, off("none").black);
}

// The facet in the middle of the picture, and light that all but runs along it: `turn` radians
// above.
dvec3 along_the_middle(double turn) {
    const Scene scene = coarse_ball(rows);
    const dvec3 to_eye = glm::normalize(scene.camera.position);
    dvec3 middle(0);
    for (const Triangle &triangle : scene.triangles) {
        const auto corners = reference::corners_of<double>(scene, triangle);
        const dvec3 facet = glm::normalize(reference::facing(corners));
        middle = glm::dot(facet, to_eye) > glm::dot(middle, to_eye) ? facet : middle;
    }
    const dvec3 right = glm::normalize(glm::cross(dvec3(0, 1, 0), middle));
    return std::cos(turn) * right + std::sin(turn) * middle;
}

// When light that turns leaves a facet, the facet must not go dark at once. A cosine changes by as
// much as the light turns, and Chiang's share of it by more.
TEST_P(Stage11Terminator, PassesWithoutAStep) {
    constexpr double turn = 1e-4;
    const auto largest_change = [](const char *method) {
        const Image before = draw_by(method, coarse_ball(rows, -along_the_middle(turn / 2))).image;
        const Image after = draw_by(method, coarse_ball(rows, -along_the_middle(-turn / 2))).image;
        float largest = 0;
        for (std::size_t i = 0; i < before.pixels.size(); ++i) {
            largest = std::max(largest, std::abs(before.pixels[i].x - after.pixels[i].x));
        }
        return largest;
    };
    EXPECT_GT(largest_change("none"), 0.1F);
    EXPECT_LT(largest_change("chiang"), 10 * turn);
    EXPECT_LT(largest_change("hanika"), 2 * turn);
}

// However many rays run side by side.
TEST_P(Stage11Terminator, IsTheSameForManyRays) {
    if (is_rusticl(GetParam())) {
        GTEST_SKIP() << "rusticl takes minutes to build what is wide";
    }
    for (const char *method : {"none", "chiang", "hanika"}) {
        const Frame one = draw_by(method, coarse_ball(rows));
        const Frame many = draw_by(method, coarse_ball(rows), "16");
        EXPECT_EQ(one.rays.shadow, many.rays.shadow) << method;
        int different = 0;
        for (std::size_t i = 0; i < one.image.pixels.size(); ++i) {
            different += glm::distance(one.image.pixels[i], many.image.pixels[i]) > 1e-5F;
        }
        EXPECT_LE(different, 2) << method;
    }
}

// Two balls, one of them half inside out, under both kinds of light.
Scene two_balls() {
    Scene scene = coarse_ball(rows);
    scene.camera.fov = 60;
    scene.width = scene.height = 64;
    add_ball(scene, {-1.7, 0.4, -1}, 0.8, 6, add_material(scene, glossy({0.9, 0.6, 0.3}, 0.2)));
    for (Vertex &vertex : scene.vertices) {
        vertex.normal *= vertex.position.x < -0.95 && vertex.position.y > 0.4 ? -1 : 1;
    }
    add_sphere(scene, {1.2, 0.9, 0.6}, 0.2, diffuse(white));
    add_plane(scene, {0, 1, 0}, {0, -1.1, 0}, diffuse({0.5, 0.6, 0.7}));
    add_point_light(scene, {2, 1.5, 3}, {1, 0.8, 0.6}, 8);
    return scene;
}

Scene from_within(Scene scene) {
    scene.camera.position = {0, 0.1, 0.2};
    add_point_light(scene, {0.3, 0.4, 0.3}, {0.3, 0.5, 0.9}, 0.3);
    return scene;
}

void expect_off_edges(const Image &image, const reference::Result &truth) {
    int compared = 0, outside = 0;
    for (std::size_t i = 0; i < truth.edge.size(); ++i) {
        if (truth.edge[i] == 0) {
            ++compared;
            outside += glm::distance(image.pixels[i], truth.image.pixels[i]) > 1.0F / 1024;
        }
    }
    EXPECT_EQ(outside, 0) << "of " << compared;
    EXPECT_GT(compared, 1500);
}

TEST_P(Stage11Terminator, IsTheReferences) {
    const bool has_doubles = has_extension(choose_device(GetParam()), "cl_khr_fp64");
    for (const Scene &scene : {two_balls(), from_within(two_balls())}) {
        for (const auto &[method, terminator] : {std::pair{"none", reference::Terminator::none},
                                                 {"chiang", reference::Terminator::chiang},
                                                 {"hanika", reference::Terminator::hanika}}) {
            SCOPED_TRACE(method);
            const auto truth = reference::render<double>(scene, {.width = scene.width,
                                                                 .height = scene.height,
                                                                 .max_depth = scene.max_depth,
                                                                 .terminator = terminator});
            expect_off_edges(draw_by(method, scene).image, truth);
            if (has_doubles) {
                RenderSettings in_double = by_terminator(method, scene);
                in_double.methods["math"] = "fp64";
                expect_off_edges(renderer("11_full_tracer", scene, in_double).render().image,
                                 truth);
            }
        }
    }
}

int smooth(const Scene &scene, int stage = 11, const char *method = "hanika") {
    const bool smooth_shadows = has_smooth_shadows({{"terminator", method}});
    return value_of(needs_of(scene, stage, scene.max_depth, cutoff_one_in, smooth_shadows),
                    "HAS_SMOOTH_MESH");
}

// The kernel has nothing of it where no light meets a smooth mesh, or the method is none.
TEST(Stage11SmoothMesh, IsANeedOfScenesThatHaveOne) {
    EXPECT_EQ(smooth(coarse_ball(rows)), 1);
    EXPECT_EQ(smooth(coarse_ball(rows), 11, "chiang"), 1);
    EXPECT_EQ(smooth(coarse_ball(rows), 11, "none"), 0);
    EXPECT_EQ(smooth(coarse_ball(rows), 10), 0);
    Scene dark = coarse_ball(rows);
    dark.lights.clear();
    EXPECT_EQ(smooth(dark), 0);
    for (const auto &[material, needs] :
         {std::pair{glossy(white, 0.5), 1}, {mirror(white), 0}, {glass(white, 1.5, {}), 0}}) {
        Scene other = coarse_ball(rows);
        other.materials[0] = material;
        add_plane(other, {0, 1, 0}, {0, -2, 0}, diffuse(white));
        EXPECT_EQ(smooth(other), needs);
    }
    Scene facets = one_pixel({0, 0, 4}, {0, 0, 0});
    add_box(facets, {-1, -1, -1}, {1, 1, 1}, add_material(facets, diffuse(white)));
    add_directional_light(facets, {0, 0, -1}, white, 1);
    EXPECT_EQ(smooth(facets), 0);
    facets.vertices[0].normal = glm::dvec3(glm::vec3(0.3, 0.4, 0.5) / std::sqrt(0.5F));
    EXPECT_EQ(smooth(facets), 1);
    for (Vertex &vertex : facets.vertices) {  // as files have them, in float
        vertex.normal = glm::dvec3(glm::vec3(vertex.normal));
    }
    EXPECT_EQ(smooth(facets), 1);
}

}  // namespace
}  // namespace stagelight::render
