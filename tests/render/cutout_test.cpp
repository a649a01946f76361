// SPDX-License-Identifier: MIT
// Colours of vertices and cut-outs, in each kernel that has a way of its own to meet triangles.
#include <cmath>

#include "render/on_each_device.h"

namespace stagelight::render {
namespace {

constexpr double eight_bits = 1.0 / 255;  // rusticl filters with them

struct Tracer {
    const char *stage;
    const char *width;  // rays of a work-item, from stage 10 on
};

void PrintTo(const Tracer &tracer, std::ostream *stream) {
    *stream << tracer.stage << " width " << tracer.width;
}

class Stage06Surfaces : public testing::TestWithParam<std::tuple<Tracer, const char *>> {
protected:
    void SetUp() override {
        const auto &[tracer, device] = GetParam();
        if (is_rusticl(device) && std::string(tracer.width) != "1") {
            GTEST_SKIP() << "rusticl takes minutes to build what is wide";
        }
    }
    static Frame draw(const Scene &scene) {
        const auto &[tracer, device] = GetParam();
        RenderSettings settings = settings_of(scene);
        if (std::string(tracer.stage) >= "10") {
            settings.methods["width"] = tracer.width;
        }
        return Renderer(choose_device(device), tracer.stage, scene, settings).render();
    }
};

std::string tracer_name(const testing::TestParamInfo<std::tuple<Tracer, const char *>> &of) {
    const auto &[tracer, device] = of.param;
    return std::string(tracer.stage) + "_Width" + tracer.width + "_" + name_in_tests(device);
}

const auto tracers = testing::Values(Tracer{"06_textures", "1"}, Tracer{"09_tree", "1"},
                                     Tracer{"10_packets", "4"}, Tracer{"11_full_tracer", "8"});
INSTANTIATE_TEST_SUITE_P(Tracers, Stage06Surfaces, testing::Combine(tracers, each_device()),
                         tracer_name);

// A square from -1 to 1 in the plane at z, its picture the right way up.
void add_square(Scene &scene, double z, int material) {
    const auto corner = [&](double x, double y) {
        return Vertex{{x, y, z}, {0, 0, 1}, {(x + 1) / 2, (1 - y) / 2}};
    };
    add_triangle(scene, corner(-1, -1), corner(1, -1), corner(1, 1), material);
    add_triangle(scene, corner(-1, -1), corner(1, 1), corner(-1, 1), material);
}

// White, of these alphas from left to right, each as wide as the others.
int add_stripes(Scene &scene, std::vector<std::uint8_t> alphas, double cutoff) {
    std::vector<std::uint8_t> texels;
    for (const std::uint8_t alpha : alphas) {
        texels.insert(texels.end(), {255, 255, 255, alpha});
    }
    scene.textures.push_back(texture_of(int(alphas.size()), 1, texels));
    scene.textures.back().wrap_u = Wrap::clamp;
    Material material = diffuse({1, 0.5, 0.25});
    material.texture = int(scene.textures.size()) - 1;
    material.alpha_cutoff = cutoff;
    return add_material(scene, material);
}

// A camera that sees x from -1 to 1 of the plane z = 0, `width` pixels each.
Scene before_square(int width) {
    Scene scene;
    scene.width = width;
    scene.height = 1;
    scene.background = {0, 0, 1};
    scene.camera = {.position = {0, 0, 1}, .look_at = {0, 0, 0}, .fov = 90};
    return scene;
}

const dvec3 lit{1, 0.5, 0.25};
const dvec3 sky{0, 0, 1};

// Alpha falls from 1 to 0 between the centres of two texels, at x from -1/2 to 1/2: below 0.375
// from x = 1/8 on. Pixels are 1/8 wide, and the two at that edge lie in one packet.
TEST_P(Stage06Surfaces, AreNotThereWhereAlphaIsLess) {
    Scene scene = before_square(16);
    add_square(scene, 0, add_stripes(scene, {255, 0}, 0.375));
    add_directional_light(scene, {0, 0, -1}, {1, 1, 1}, 1);
    const Image image = draw(scene).image;
    for (int x = 0; x < 16; ++x) {
        expect_color(image, x, 0, (x + 0.5) / 8 - 1 < 0.125 ? lit : sky, eight_bits);
    }
}

// Exactly at the threshold it is there: no rounding of the filter makes holes.
TEST_P(Stage06Surfaces, AreThereWhereAlphaIsTheCutoff) {
    Scene scene = before_square(16);
    add_square(scene, 0, add_stripes(scene, {255, 255, 255}, 1));
    add_directional_light(scene, {0, 0, -1}, {1, 1, 1}, 1);
    const Image image = draw(scene).image;
    for (int x = 0; x < 16; ++x) {
        expect_color(image, x, 0, lit, eight_bits);
    }
}

// What is behind a hole is seen, and what is before it hides it; nearer triangles are tried first
// or last, and the order says nothing.
TEST_P(Stage06Surfaces, ShowWhatIsBehindThem) {
    for (const bool front_first : {true, false}) {
        Scene scene = before_square(8);
        const int front = add_stripes(scene, {255, 255, 0, 0}, 0.5);
        const int back = add_material(scene, diffuse({0, 1, 0}));
        add_square(scene, front_first ? 0 : -0.01, front_first ? front : back);
        add_square(scene, front_first ? -0.01 : 0, front_first ? back : front);
        add_directional_light(scene, {0, 0, -1}, {1, 1, 1}, 1);
        const Image image = draw(scene).image;
        expect_color(image, 0, 0, lit, eight_bits);
        expect_color(image, 7, 0, {0, 1, 0}, eight_bits);
    }
}

// A floor at z = -1, before it the square, held up to the light: its left half throws a shadow.
TEST_P(Stage06Surfaces, LetLightThroughTheirHoles) {
    for (const LightType type : {LightType::point, LightType::directional}) {
        Scene scene = before_square(2);
        scene.camera = {.position = {0, 0, 0.5}, .look_at = {0, 0, -1}, .fov = 40};
        // The camera is between the square and the floor.
        add_square(scene, 1, add_stripes(scene, {255, 255, 0, 0}, 0.5));
        add_plane(scene, {0, 0, 1}, {0, 0, -1}, diffuse({1, 1, 1}));
        if (type == LightType::point) {
            add_point_light(scene, {0, 0, 1000}, {1, 1, 1}, 1001 * 1001);
        } else {
            add_directional_light(scene, {0, 0, -1}, {1, 1, 1}, 1);
        }
        const Image image = draw(scene).image;
        expect_color(image, 0, 0, {0, 0, 0}, 1e-3);
        expect_color(image, 1, 0, {1, 1, 1}, 1e-3);
    }
}

// Seen in a mirror, which the eye faces with its back to the square. The light comes from the
// mirror's side, at 45 degrees, past it.
TEST_P(Stage06Surfaces, AreCutOutForReflectedRays) {
    Scene scene = before_square(2);
    const int glass = add_material(scene, mirror({1, 1, 1}));
    add_flat_triangle(scene, {-0.3, -0.3, 0}, {0.3, -0.3, 0}, {0.3, 0.3, 0}, glass);
    add_flat_triangle(scene, {-0.3, -0.3, 0}, {0.3, 0.3, 0}, {-0.3, 0.3, 0}, glass);
    add_square(scene, 1.5, add_stripes(scene, {255, 255, 0, 0}, 0.5));
    scene.camera.fov = 30;
    add_directional_light(scene, glm::normalize(dvec3(1, 0, 1)), {1, 1, 1}, std::sqrt(2.0));
    const Image image = draw(scene).image;
    expect_color(image, 0, 0, lit, eight_bits);
    expect_color(image, 1, 0, sky, eight_bits);
}

// Of two materials with one picture, only the one with a cutoff is cut out; and glass never is.
TEST_P(Stage06Surfaces, AreWholeWithoutACutoff) {
    Scene scene = before_square(2);
    const int cut = add_stripes(scene, {0}, 0.5);
    Material whole = scene.materials[std::size_t(cut)];
    whole.alpha_cutoff = 0;
    add_square(scene, 0.1, cut);
    add_square(scene, 0, add_material(scene, whole));
    add_directional_light(scene, {0, 0, -1}, {1, 1, 1}, 1);
    expect_color(draw(scene).image, 0, 0, lit, eight_bits);
}

// At the triangle's centre a third of each corner's, at a corner's place its own; times the
// material's.
TEST_P(Stage06Surfaces, BlendColorsOfVertices) {
    Scene scene = before_square(1);
    const auto corner = [](double x, double y, dvec3 color) {
        return Vertex{{x, y, 0}, {0, 0, 1}, {0, 0}, color};
    };
    add_triangle(scene, corner(-3, -3, {0.9, 0, 0.3}), corner(3, -3, {0, 0.6, 0.3}),
                 corner(0, 6, {0, 0, 0.9}), add_material(scene, diffuse({1, 0.5, 1})));
    add_directional_light(scene, {0, 0, -1}, {1, 1, 1}, 1);
    expect_color(draw(scene).image, 0, 0, {0.3, 0.1, 0.5});
    scene.camera.position = {2.999, -2.9995, 1};
    scene.camera.look_at = {2.999, -2.9995, 0};
    expect_color(draw(scene).image, 0, 0, {0, 0.3, 0.3}, 1e-3);
}

}  // namespace
}  // namespace stagelight::render
