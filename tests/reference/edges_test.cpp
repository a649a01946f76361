// SPDX-License-Identifier: MIT
// The edge mask, held to outlines in closed form.
#include <functional>

#include "reference/camera.h"
#include "reference/patches.h"
#include "reference/reference.h"
#include "scenes.h"

namespace stagelight::reference {
namespace {

const Settings small{.width = 64, .height = 48};

using Mask = std::vector<std::uint8_t>;

// 1 in the 3x3 around each pixel of whose four neighbours one is of another class.
Mask outline(const Scene &scene, const std::function<int(const Ray<double> &)> &class_of) {
    const auto at = [&](int x, int y) {
        return class_of(primary_ray(scene.camera, small.width, small.height, x + 0.5, y + 0.5));
    };
    const auto inside = [](int x, int y) {
        return x >= 0 && y >= 0 && x < small.width && y < small.height;
    };
    const auto beside = [&](int x, int y) {
        for (const auto &[dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
            if (inside(x, y) && inside(x + dx, y + dy) && at(x, y) != at(x + dx, y + dy))
                return true;
        return false;
    };
    Mask mask;
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            bool near = false;
            for (int i = 0; i < 9; ++i)
                near = near || beside(x + i % 3 - 1, y + i / 3 - 1);
            mask.push_back(near);
        }
    return mask;
}

std::string drawn(const Mask &mask) {
    std::string rows;
    for (std::size_t i = 0; i < mask.size(); ++i)
        rows += std::string(i % std::size_t(small.width) ? "" : "\n") + (mask[i] ? '#' : '.');
    return rows;
}

void expect_mask(const Scene &scene, const Mask &expected,
                 std::source_location at = std::source_location::current()) {
    const Mask mask = render<double>(scene, small).edge;
    if (mask != expected)
        ADD_FAILURE_AT(at.file_name(), int(at.line()))
            << "is" << drawn(mask) << "\nexpected" << drawn(expected);
}

int passes(const Ray<double> &along, dvec3 center, double radius) {
    const dvec3 way = center - along.origin;
    return glm::length(way - glm::dot(way, along.direction) * along.direction) < radius ? 1 : 0;
}

Scene before_a_ball(Material material) {
    Scene scene;
    scene.camera.position = {0.1, 0.2, 4};
    scene.background = {0.2, 0.3, 0.4};
    add_sphere(scene, {0, 0, 0}, 1, material);
    return scene;
}

Mask ball_outline(const Scene &scene) {
    return outline(scene, [](const Ray<double> &along) { return passes(along, {0, 0, 0}, 1); });
}

TEST(ReferenceEdges, OfASphereAreItsOutlineAlone) {
    Scene scene = before_a_ball(diffuse({1, 1, 1}));
    const Mask expected = ball_outline(scene);
    EXPECT_GT(std::count(expected.begin(), expected.end(), 1), 100);
    expect_mask(scene, expected);
    // Where the ball turns away from the light there is no jump, hence no edge.
    add_directional_light(scene, {-1, 0, 0}, {1, 1, 1}, 1);
    expect_mask(scene, expected);
    // Nor at the seam of a picture around it.
    scene.camera.position = {0.1, 0.2, -4};
    scene.textures.push_back(texture_of(1, 1, {1, 2, 3, 4}));
    scene.materials[0].texture = 0;
    expect_mask(scene, ball_outline(scene));
}

// All that a glass ball shows of an empty world, at any depth, is smooth: reflections whose
// weight passes below what can be seen leave no mark.
TEST(ReferenceEdges, OfAGlassBallInAnEmptyWorldAreItsOutlineAlone) {
    const Scene scene = before_a_ball(glass({1, 1, 1}, 1.5, {0, 1, 3}));
    expect_mask(scene, ball_outline(scene));
}

// A ball of radius r at height h over a floor, a light at H above both, and an eye at C looking
// down: on the floor the ball hides a disc of radius C r / sqrt((C-h)² - r²), and its shadow has
// H r / sqrt((H-h)² - r²).
TEST(ReferenceEdges, ShadowsHaveThem) {
    const double r = 0.5, h = 1, H = 3, C = 6;
    const double hidden = C * r / std::sqrt((C - h) * (C - h) - r * r);
    const double shaded = H * r / std::sqrt((H - h) * (H - h) - r * r);
    Scene scene;
    scene.camera = {.position = {0, C, 0}, .look_at = {0, 0, 0}, .up = {0, 0, -1}, .fov = 40};
    add_plane(scene, {0, 1, 0}, {0, 0, 0}, diffuse({1, 1, 1}));
    add_sphere(scene, {0, h, 0}, r, diffuse({1, 1, 1}));
    add_point_light(scene, {0, H, 0}, {1, 1, 1}, 9);
    expect_mask(scene, outline(scene, [&](const Ray<double> &along) {
                    const double from_axis =
                        C * std::hypot(along.direction.x, along.direction.z) / -along.direction.y;
                    return from_axis < hidden ? 0 : from_axis < shaded ? 1 : 2;
                }));
}

// The ball stands behind the eye. In the mirror z = 0 it is seen as its image at -z.
TEST(ReferenceEdges, MirrorsShowThem) {
    Scene scene;
    scene.camera.position = {0, 0, 2};
    add_plane(scene, {0, 0, 1}, {0, 0, 0}, mirror({0.9, 0.9, 0.9}));
    add_sphere(scene, {0.3, 0.2, 4}, 1, diffuse({1, 1, 1}));
    expect_mask(scene, outline(scene, [](const Ray<double> &along) {
                    return passes(along, {0.3, 0.2, -4}, 1);
                }));
}

TEST(ReferenceEdges, GlassShowsThem) {
    Scene scene = before_a_ball(glass({1, 1, 1}, 1.5, {}));
    const Mask outer = ball_outline(scene);
    add_sphere(scene, {0, 0, -3}, 0.4, diffuse({1, 1, 1}));  // wholly behind the ball
    const Mask mask = render<double>(scene, small).edge;
    EXPECT_GT(std::count(mask.begin(), mask.end(), 1),
              std::count(outer.begin(), outer.end(), 1) + 50)
        << drawn(mask);
    // So dense that nothing can be seen in it, it shows none.
    scene.materials[0].absorption = {10, 10, 10};
    expect_mask(scene, outer);
}

// A smooth ball of 2048 facets has an outline and no more; one of flat facets has its facets too.
TEST(ReferenceEdges, OfASmoothMeshAreItsOutlineAlone) {
    Scene scene;
    scene.camera.position = {0.1, 0.2, 4};
    add_ball(scene, {0, 0, 0}, 1, 32, add_material(scene, diffuse({1, 1, 1})));
    const World<double> world(scene);
    expect_mask(scene, outline(scene, [&](const Ray<double> &along) {
                    return world.closest_hit(along) ? 1 : 0;
                }));
    for (Triangle &triangle : scene.triangles) {
        auto &v = triangle.vertices;
        const dvec3 normal = facing(corners_of<double>(scene, triangle));
        for (const auto corner : v)
            scene.vertices[corner].normal =
                normal == dvec3(0) ? dvec3(0, 1, 0) : glm::normalize(normal);
    }
    const Mask flat = render<double>(scene, small).edge;
    EXPECT_GT(std::count(flat.begin(), flat.end(), 1), 800) << drawn(flat);
}

// Two triangles that share an edge: one patch while their corners agree in every number.
TEST(ReferenceEdges, PatchesEndWhereAnyNumberOfTheirCornersJumps) {
    const auto patches = [](auto change) {
        Scene scene;
        add_material(scene, diffuse({1, 1, 1}));
        add_material(scene, diffuse({1, 1, 1}));
        scene.materials[0].texture = 0;
        const dvec3 up(0, 0, 1);
        Vertex a{{0, 0, 0}, up, {0, 0}}, b{{1, 0, 0}, up, {1, 0}}, c{{0, 1, 0}, up, {0, 1}};
        const Vertex d{{1, 1, 0}, up, {1, 1}};
        add_triangle(scene, a, b, c);
        change(b);
        change(c);
        add_triangle(scene, b, d, c);
        const std::vector<int> of = smooth_patches(scene);
        return of[0] == of[1] ? 1 : 2;
    };
    EXPECT_EQ(patches([](Vertex &) {}), 1);
    EXPECT_EQ(patches([](Vertex &v) { v.texture_coordinates.x += 1; }), 2) << "a seam in u";
    EXPECT_EQ(patches([](Vertex &v) { v.texture_coordinates.y += 1; }), 2) << "a seam in v";
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(patches([axis](Vertex &v) { v.position[axis] += 1; }), 2) << axis;
        EXPECT_EQ(patches([axis](Vertex &v) { v.normal[axis] -= 0.5; }), 2) << axis;
    }
}

RayTree facet(dvec3 point, double degrees) {
    const dvec3 normal(std::sin(glm::radians(degrees)), 0, std::cos(glm::radians(degrees)));
    return {.surface = {Surface::Kind::patch, 3},
            .point = point,
            .shading_normal = normal,
            .geometric_normal = normal,
            .weight = 1};
}

TEST(ReferenceEdges, WithinAPatchAreCreasesAndJumps) {
    EXPECT_FALSE(differ(facet({0, 0, 0}, 0), facet({0.1, 0, 0}, 15)));
    EXPECT_TRUE(differ(facet({0, 0, 0}, 0), facet({0.1, 0, 0}, 25))) << "a crease";
    EXPECT_TRUE(differ(facet({0, 0, 0}, 0), facet({0.1, 0, -0.2}, 0))) << "a jump";
    // Two points of one unit circle, however far apart, make no jump: seen at a slant.
    EXPECT_FALSE(differ(facet({std::sin(1.4), 0, std::cos(1.4)}, glm::degrees(1.4)),
                        facet({std::sin(1.1), 0, std::cos(1.1)}, glm::degrees(1.1))));
}

TEST(ReferenceEdges, ComeFromAnyNodeThatCanBeSeen) {
    const RayTree plain = facet({0, 0, 0}, 0);
    const auto with = [&](auto change) {
        RayTree tree = plain;
        tree.shadows = {Shadow::lit};
        tree.children = {plain, plain};
        change(tree);
        return tree;
    };
    const RayTree same = with([](RayTree &) {});
    EXPECT_FALSE(differ(same, with([](RayTree &) {})));
    EXPECT_TRUE(differ(same, with([](RayTree &t) { t.surface.index = 4; })));
    EXPECT_TRUE(differ(same, with([](RayTree &t) { t.from_behind = true; })));
    EXPECT_TRUE(differ(same, with([](RayTree &t) { t.shadows[0] = Shadow::blocked; })));
    EXPECT_FALSE(differ(same, with([](RayTree &t) { t.shadows[0] = Shadow::unlit; })));
    EXPECT_TRUE(differ(same, with([](RayTree &t) { t.children.pop_back(); })));
    EXPECT_TRUE(differ(same, with([](RayTree &t) { t.children[1].surface = {}; })));
    EXPECT_FALSE(differ(same, with([](RayTree &t) {
                            t.children[1].surface = {};
                            t.children[1].weight = 0.9e-3;
                        })));
}

}  // namespace
}  // namespace stagelight::reference
