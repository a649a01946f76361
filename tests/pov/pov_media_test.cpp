// SPDX-License-Identifier: MIT
// Dielectrics in each other and around the eye, in POV-Ray's words: docs/pov-ray.md, "Glass in
// glass".
#include <array>

#include <fmt/format.h>

#include "pov/exported.h"
#include "pov/pov_media.h"
#include "scene/errors.h"

namespace stagelight::pov {
namespace {

const dvec3 red(0.25, 0.5, 1);

// With the eye 8 from the origin, a scene with shells is made 64 times as large.
Scene seen_from(dvec3 eye) {
    Scene scene;
    scene.camera.position = eye;
    scene.camera.look_at = eye - dvec3(0, 0, 1);
    return scene;
}

Scene bubble_in_glass(dvec3 eye) {
    Scene scene = seen_from(eye);
    add_sphere(scene, {0, 0, 0}, 2, glass({1, 1, 1}, 1.5, red));
    add_sphere(scene, {0, 0, 1}, 0.5, glass({1, 1, 1}, 1, {0, 0, 0}));
    return scene;
}

class ExportMedia : public Export {
protected:
    // The objects that share the interior of a material.
    static std::string union_with(const std::string &text, int material) {
        const auto end =
            text.find(fmt::format("interior {{ interior_{} }} no_shadow }}", material));
        const auto begin = text.rfind("union {", end);
        return end == std::string::npos || begin == std::string::npos
                   ? ""
                   : text.substr(begin, end - begin);
    }
};

TEST_F(ExportMedia, ASurfaceBetweenTwoIsTwoShells) {
    const std::string text = exported(bubble_in_glass({0, 0, 8}));
    expect_part(text, "#declare body_0 = sphere { <0, 0, 0>, 128 }");
    expect_part(text, "#declare body_1 = sphere { <0, 0, 64>, 32 }");
    expect_part(text, "#declare shell_1 = sphere { <0, 0, 64>, 32.0004 }");
    const std::string in_glass = union_with(text, 0), in_bubble = union_with(text, 1);
    expect_part(in_glass, "object { body_0 clipped_by { object { body_1 inverse } } "
                          "texture { material_0 } hollow }");
    expect_part(in_glass, "object { body_1 clipped_by { object { body_0 } } texture { through } "
                          "interior_texture { material_1 } hollow }");
    expect_part(in_bubble, "object { shell_1 clipped_by { object { body_0 } } texture { material_1 "
                           "} interior_texture { through } hollow }");
    expect_part(in_bubble, "object { body_1 clipped_by { object { body_0 inverse } } "
                           "texture { material_1 } hollow }");
}

TEST_F(ExportMedia, EachCastsItsWholeShadow) {
    const std::string text = exported(bubble_in_glass({0, 0, 8}));
    for (const char *body : {"body_0", "body_1"}) {
        expect_part(text, fmt::format("object {{ {} pigment {{ rgb 0 }} hollow no_image "
                                      "no_reflection }}",
                                      body));
    }
}

// Of three that overlap, the lowest one's surface is there where no other body is, the middle one
// has the lowest or air around it, and the highest any of them.
TEST_F(ExportMedia, SurfacesAreCutByPrecedence) {
    Scene scene = seen_from({0, 0, 8});
    for (const int priority : {2, 0, 1}) {
        Material material = glass({1, 1, 1}, 1.5, {0, 0, 0});
        material.priority = priority;
        add_sphere(scene, {0.5 * priority, 0, 0}, 1, material);
    }
    const std::string text = exported(scene);
    const std::string lowest = union_with(text, 1), middle = union_with(text, 2),
                      highest = union_with(text, 0);
    expect_part(lowest, "object { body_0 clipped_by { object { body_1 inverse } "
                        "object { body_2 inverse } } texture { material_1 } hollow }");
    expect_part(middle, "shell_1 clipped_by { object { body_0 } object { body_2 inverse } }");
    expect_part(middle,
                "body_1 clipped_by { object { body_0 inverse } object { body_2 inverse } }");
    expect_part(highest, "shell_2 clipped_by { object { body_0 } object { body_1 inverse } }");
    expect_part(highest, "shell_2 clipped_by { object { body_1 } }");
    expect_part(highest,
                "body_2 clipped_by { object { body_0 inverse } object { body_1 inverse } }");
    expect_part(lowest, "body_2 clipped_by { object { body_0 } object { body_1 inverse } }");
    expect_part(middle, "body_2 clipped_by { object { body_1 } }");
}

// POV-Ray begins with the interiors of what holds the eye.
TEST_F(ExportMedia, OnlyTheMediumOfTheEyeHoldsIt) {
    const std::string text = exported(bubble_in_glass({0, 0, 1.25}));
    expect_part(union_with(text, 0), "texture { material_0 } hollow inverse }");
    expect_part(union_with(text, 0), "body_1 clipped_by { object { body_0 } } texture { material_1 "
                                     "} interior_texture { through } hollow inverse }");
    expect_part(union_with(text, 1), "shell_1 clipped_by { object { body_0 } } texture { through } "
                                     "interior_texture { material_1 } hollow inverse }");
    expect_part(union_with(text, 1), "texture { material_1 } hollow }");
    expect_part(text, "object { body_0 pigment { rgb 0 } hollow no_image no_reflection inverse }");
}

TEST_F(ExportMedia, AnEyeInOneNeedsNoShells) {
    Scene scene = seen_from({0, 0, 1});
    add_sphere(scene, {0, 0, 0}, 2, glass({1, 1, 1}, 1.5, red));
    add_sphere(scene, {0, 9, 0}, 2, glass({1, 1, 1}, 1.5, red));
    const std::string text = exported(scene);
    expect_part(text, "#declare body_0 = sphere { <0, 0, 0>, 2 }");
    expect_no_part(text, "shell_");
    expect_part(text, "object { sphere { <0, 9, 0>, 2 } texture { material_1 } interior");
}

// Else a ray would always be in two interiors, and reflect nothing where it leaves glass.
TEST_F(ExportMedia, NothingElseHoldsTheEye) {
    Scene scene = seen_from({0, 0, 8});
    add_plane(scene, {0, 1, 0}, {0, 1, 0}, diffuse({1, 1, 1}));
    add_plane(scene, {0, 1, 0}, {0, -1, 0}, diffuse({1, 1, 1}));
    add_sphere(scene, {0, 0, 0}, 9, diffuse({1, 1, 1}));
    add_sphere(scene, {0, 0, 0}, 7, diffuse({1, 1, 1}));
    const std::string text = exported(scene);
    expect_part(text, "plane { <0, 1, 0>, 1 } texture { material_0 } hollow inverse }");
    expect_part(text, "plane { <0, 1, 0>, -1 } texture { material_1 } hollow }");
    expect_part(text, "sphere { <0, 0, 0>, 9 } texture { material_2 } hollow inverse }");
    expect_part(text, "sphere { <0, 0, 0>, 7 } texture { material_3 } hollow }");
}

TEST_F(ExportMedia, ALargerSceneLooksTheSame) {
    Scene scene = bubble_in_glass({0, 0, 8});
    add_plane(scene, {0, 1, 0}, {0, -3, 0}, diffuse({1, 1, 1}));
    add_point_light(scene, {0, 4, 0}, {1, 1, 1}, 6);
    add_directional_light(scene, {0, -1, 0}, {1, 1, 1}, 2);
    const std::string text = exported(scene);
    expect_near(vector_after(text, "location"), {0, 0, 512}, 1e-9);
    expect_part(text, "plane { <0, 1, 0>, -192 }");
    expect_part(text, "absorption rgb <0.00390625, 0.0078125, 0.015625> ");
    expect_part(text, "<2, 2, 2> parallel");
    expect_near(vector_after(text, "light_source"), {0, 256, 0}, 1e-9);
    const double fade = number_after(text, "fade_distance");
    const dvec3 color = vector_after(text.substr(text.find("light_source")), "rgb");
    expect_near(2 * fade * fade * color / 4096.0, {6, 6, 6}, 1e-9);
}

// POV-Ray absorbs on the way to what a ray meets, and not to the background.
TEST_F(ExportMedia, WaterEndsAtABackdrop) {
    Scene scene = seen_from({0, 0, 8});
    scene.background = {0.25, 0.5, 0.75};
    add_plane(scene, {0, 1, 0}, {0, -1, 0}, diffuse({1, 1, 1}));
    expect_no_part(exported(scene), "emission");
    add_plane(scene, {0, 1, 0}, {0, 0, 0}, glass({1, 1, 1}, 1.33, red));
    expect_part(exported(scene),
                "sphere { <0, 0, 8>, 8000 pigment { rgb <0.25, 0.5, 0.75> } finish { "
                "ambient 0 diffuse 0 emission 1 } hollow no_shadow inverse }");
}

class ExportMeshMedia : public ExportMedia {
protected:
    // With a bubble in it.
    static Scene tetrahedron() {
        Scene scene = seen_from({0, 0, 8});
        scene.meshes.push_back({.file = {}, .where = {"scene.toml", 5, 1}});
        add_material(scene, glass({1, 1, 1}, 1.5, {0, 0, 0}));
        const std::array<dvec3, 4> corners{dvec3(0, 0, 0), dvec3(4, 0, 0), dvec3(0, 4, 0),
                                           dvec3(0, 0, 4)};
        for (const auto &[a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
            const auto corner = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
            const dvec3 normal =
                glm::normalize(glm::cross(corner(b) - corner(a), corner(c) - corner(a)));
            add_triangle(scene, {corner(a), normal, {}}, {corner(b), normal, {}},
                         {corner(c), normal, {}});
        }
        add_sphere(scene, {0.75, 0.75, 0.75}, 0.5, glass({1, 1, 1}, 1, {0, 0, 0}));
        return scene;
    }
};

TEST_F(ExportMeshMedia, KnowsItsInside) {
    const std::string text = exported(tetrahedron());
    const std::string body = text.substr(text.find("#declare body_0"));
    expect_part(body, "face_indices { 4,\n<0, 2, 1>");
    expect_part(body, "inside_vector");
}

// The corner of three faces at right angles moves along all three.
TEST_F(ExportMeshMedia, MovesEachFaceOutwards) {
    Scene scene = tetrahedron();
    scene.spheres[0].radius = 5;  // the mesh is the smaller one
    const std::string text = exported(scene);
    const std::string shell = text.substr(text.find("#declare shell_1 = mesh2"));
    expect_near(vector_after(shell, "vertex_vectors"), dvec3(-shell_distance), 1e-9);
}

TEST_F(ExportMeshMedia, OfSeveralMaterialsIsRefused) {
    Scene scene = tetrahedron();
    scene.triangles[2].material = add_material(scene, glass({1, 1, 1}, 1.2, {0, 0, 0}));
    EXPECT_THROW(export_pov(scene, {}, file()), UserError);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace stagelight::pov
