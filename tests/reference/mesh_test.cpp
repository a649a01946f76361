// SPDX-License-Identifier: MIT
// Smooth normals, the side a triangle shows, smooth patches, and scale.
#include "reference/patches.h"
#include "reference/reference.h"
#include "scenes.h"

namespace stagelight::reference {
namespace {

// N = normalize((1-u-v) Na + u Nb + v Nc); over the right-angled triangle u = x and v = y.
TEST(ReferenceStage05Normals, AreBlendedByTheBarycentricCoordinates) {
    const dvec3 na(0, 0, 1), nb = glm::normalize(dvec3(1, 0, 1)),
                             nc = glm::normalize(dvec3(0, 1, 2));
    Scene scene;
    add_triangle(scene, {{0, 0, 0}, na, {}}, {{1, 0, 0}, nb, {}}, {{0, 1, 0}, nc, {}},
                 add_material(scene, diffuse({1, 1, 1})));
    const auto normals_at = [&](double x, double y, double side) {
        const RayTree tree = met(scene, ray({x, y, side}, {0, 0, -side}));
        return std::pair(tree.shading_normal, tree.geometric_normal);
    };
    for (const auto &[u, v] : {std::pair{0.25, 0.5}, {0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}) {
        const dvec3 expected = glm::normalize((1 - u - v) * na + u * nb + v * nc);
        expect_near(normals_at(u, v, 1).first, expected, 1e-15);
        expect_near(normals_at(u, v, 1).second, {0, 0, 1}, 1e-15);
        // Seen from behind both are turned.
        expect_near(normals_at(u, v, -1).first, -expected, 1e-15);
        expect_near(normals_at(u, v, -1).second, {0, 0, -1}, 1e-15);
    }
}

// Which way the corners run round does not matter: G is turned to the side of N.
TEST(ReferenceStage05Normals, DecideTheFrontNotTheWinding) {
    for (const bool swapped : {false, true}) {
        Scene scene;
        const Vertex a{{0, 0, 0}, {0, 0, 1}, {}}, b{{1, 0, 0}, {0, 0, 1}, {}},
            c{{0, 1, 0}, {0, 0, 1}, {}};
        add_triangle(scene, a, swapped ? c : b, swapped ? b : c, add_material(scene, {}));
        EXPECT_FALSE(met(scene, ray({0.2, 0.2, 1}, {0, 0, -1})).from_behind);
        EXPECT_TRUE(met(scene, ray({0.2, 0.2, -1}, {0, 0, 1})).from_behind);
    }
}

TEST(ReferenceStage05Patches, JoinWhatIsShadedOnAcrossItsEdges) {
    Scene scene;
    const int paint = add_material(scene, {}), other = add_material(scene, {});
    const dvec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(1, 1, 0), top(0, 0, 1);
    add_flat_triangle(scene, a, b, c, paint);
    add_flat_triangle(scene, b, d, c, paint);    // the other half of a square
    add_flat_triangle(scene, a, top, b, paint);  // at a right angle to it: other normals
    add_flat_triangle(scene, b, d, c, other);    // another material
    const auto patches = smooth_patches(scene);
    EXPECT_EQ(patches[0], patches[1]);
    EXPECT_NE(patches[0], patches[2]);
    EXPECT_NE(patches[0], patches[3]);
    // Texture coordinates that jump part it too, where there is a texture to see it by.
    scene.vertices[3].texture_coordinates = scene.vertices[5].texture_coordinates = {0.5, 0.5};
    EXPECT_EQ(smooth_patches(scene)[0], smooth_patches(scene)[1]);
    scene.materials[0].texture = 0;
    EXPECT_NE(smooth_patches(scene)[0], smooth_patches(scene)[1]);
}

Scene ball_on_floor(double scale) {
    Scene scene;
    scene.camera = {.position = scale * dvec3(0, 1, 3), .look_at = scale * dvec3(0, 0.4, 0)};
    add_ball(scene, scale * dvec3(0, 0.5, 0), 0.5 * scale, 12,
             add_material(scene, diffuse({0.8, 0.5, 0.3})));
    add_flat_triangle(scene, scale * dvec3(-4, 0, 4), scale * dvec3(4, 0, 4),
                      scale * dvec3(0, 0, -5), add_material(scene, glossy({0.9, 0.9, 0.9}, 0.3)));
    add_point_light(scene, scale * dvec3(1, 3, 2), {1, 1, 1}, 8 * scale * scale);
    return scene;
}

// A scene a thousand times larger or smaller, the light's power with the square, gives the same
// picture, but for a few pixels whose ray rounds to the other side of an edge.
TEST(ReferenceStage05Meshes, SizeDoesNotMatter) {
    const Settings settings{.width = 48, .height = 32};
    const auto unscaled = render<double>(ball_on_floor(1), settings);
    for (const double scale : {1e-3, 1e3}) {
        const auto scaled = render<double>(ball_on_floor(scale), settings);
        EXPECT_EQ(scaled.edge, unscaled.edge);
        for (std::size_t i = 0; i < unscaled.edge.size(); ++i)
            expect_near(scaled.image.pixels[i], unscaled.image.pixels[i], 1e-6);
    }
}

}  // namespace
}  // namespace stagelight::reference
