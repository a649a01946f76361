// SPDX-License-Identifier: MIT
// A scene in POV-Ray's words. That POV-Ray draws it as we do is for tests/povray to
// show.
#include <cmath>

#include "cli/picture_file.h"
#include "pov/exported.h"

namespace stagelight::pov {
namespace {

constexpr double rounding = 1e-12;

// POV-Ray's ray through the point (x, y), from -1/2 to 1/2 each, is direction + x right + y up.
TEST_F(Export, CameraIsOurs) {
    Scene scene;
    scene.camera = {.position = {1, 2, 3}, .look_at = {1, 2, -4}, .up = {0, 5, 1}, .fov = 90};
    const std::string text = exported(scene, {.width = 400, .height = 100});
    expect_near(vector_after(text, "location"), {1, 2, 3}, rounding);
    expect_near(vector_after(text, "direction"), {0, 0, -1}, rounding);
    expect_near(vector_after(text, "right"), {2, 0, 0}, rounding);
    expect_near(vector_after(text, "up"), {0, 0.5, 0}, rounding);
}

// The primary ray is POV-Ray's first level.
TEST_F(Export, DepthCountsBounces) {
    expect_part(exported({}, {.max_depth = 3}), "max_trace_level 4 ");
}

TEST_F(Export, LightIsLinear) {
    Scene scene;
    scene.background = {0.25, 0.5, 0.75};
    const std::string text = exported(scene);
    expect_part(text, "assumed_gamma 1 ");
    expect_part(text, "background { rgb <0.25, 0.5, 0.75> }");
}

// POV-Ray's law, worked out: 2 / (1 + (d / fade_distance)^2) of the colour.
TEST_F(Export, PointLightFadesWithTheSquare) {
    Scene scene;
    scene.camera.position = {0, 0, 8};
    add_point_light(scene, {1, 2, 3}, {1, 0.5, 0}, 6);
    const std::string text = exported(scene);
    expect_near(vector_after(text, "light_source"), {1, 2, 3}, rounding);
    expect_part(text, "fade_power 2");
    const double fade = number_after(text, "fade_distance");
    const dvec3 color = vector_after(text.substr(text.find("light_source")), "rgb");
    for (const double distance : {0.1, 1.0, 10.0, 100.0}) {
        const double share = 2 / (1 + std::pow(distance / fade, 2));
        expect_near(distance * distance * share * color, {6, 3, 0}, 1e-5);
    }
}

// All else is at the origin, which says nothing of how large the scene is.
TEST_F(Export, LightsOfASceneWithoutExtent) {
    Scene scene;
    add_plane(scene, {0, 1, 0}, {0, 0, 0}, diffuse({1, 1, 1}));
    add_point_light(scene, {0, 2, 0}, {1, 1, 1}, 1);
    add_directional_light(scene, {0, -1, 0}, {1, 1, 1}, 1);
    const std::string text = exported(scene);
    EXPECT_GT(number_after(text, "fade_distance"), 0);
    expect_near(vector_after(text.substr(text.rfind("light_source")), "light_source"), {0, 1e4, 0},
                rounding);
}

// It shines from a plane on: nothing of the scene may lie behind that.
TEST_F(Export, DirectionalLightIsFarBehindEverything) {
    Scene scene;
    add_sphere(scene, {0, 300, 0}, 50, diffuse({1, 1, 1}));
    add_directional_light(scene, {0.6, -0.8, 0}, {1, 1, 0.5}, 2);
    const std::string text = exported(scene);
    const dvec3 position = vector_after(text, "light_source");
    expect_near(glm::normalize(-position), {0.6, -0.8, 0}, rounding);
    EXPECT_GT(glm::length(position), 1000 * 350);
    expect_part(text, " rgb <2, 2, 1> parallel point_at 0 ");
    expect_no_part(text, "fade");
}

TEST_F(Export, SurfacesReflectTheirShare) {
    Scene scene;
    add_sphere(scene, {1, 2, 3}, 0.5, diffuse({0.25, 0.5, 1}));
    add_sphere(scene, {1, 2, 3}, 0.5, mirror({1, 0.5, 0.5}));
    add_sphere(scene, {1, 2, 3}, 0.5, glossy({0.5, 1, 1}, 0.25));
    const std::string text = exported(scene);
    expect_part(text, "material_0 = texture { pigment { rgb <0.25, 0.5, 1> } "
                      "finish { ambient 0 diffuse 1 } }");
    expect_part(text, "finish { ambient 0 diffuse 0 reflection { rgb <1, 0.5, 0.5> } }");
    expect_part(text, "material_2 = texture { pigment { rgb <0.5, 1, 1> } "
                      "finish { ambient 0 diffuse 0.75 reflection { rgb <0.125, 0.25, 0.25> } } }");
    expect_part(text, "object { sphere { <1, 2, 3>, 0.5 } texture { material_2 } hollow }");
}

// Beer's law is a medium's; the shadow is full, and that of a copy which is not seen.
TEST_F(Export, GlassRefractsAbsorbsAndCastsItsShadow) {
    Scene scene;
    scene.camera.position = {0, 0, 8};
    add_sphere(scene, {0, 0, 0}, 1, glass({1, 1, 1}, 1.5, {0, 0.5, 2}));
    const std::string text = exported(scene);
    expect_part(text, "rgb <1, 1, 1> filter 1 ");
    expect_part(text, "reflection { rgb 0, rgb <1, 1, 1> fresnel on } conserve_energy");
    expect_part(text, "ior 1.5 media { absorption rgb <0, 0.5, 2> ");
    expect_part(text, "texture { material_0 } interior { interior_0 } hollow no_shadow }");
    expect_part(text, "object { sphere { <0, 0, 0>, 1 } pigment { rgb 0 } hollow no_image "
                      "no_reflection }");
}

TEST_F(Export, ClearGlassHasNoMedium) {
    Scene scene;
    add_sphere(scene, {0, 0, 0}, 1, glass({1, 1, 1}, 1.5, {0, 0, 0}));
    expect_no_part(exported(scene), "media {");
}

TEST_F(Export, PlaneIsAtItsDistance) {
    Scene scene;
    add_plane(scene, {0, 0.6, 0.8}, {7, 0, 10}, diffuse({1, 1, 1}));
    expect_part(exported(scene), "plane { <0, 0.6, 0.8>, 8 }");
}

class ExportMesh : public Export {
protected:
    // Of two materials that share vertices. A scene with meshes and a reach of 1.4 is made 512
    // times as large.
    static Scene two_triangles() {
        Scene scene;
        scene.meshes.push_back({});
        add_material(scene, diffuse({1, 0, 0}));
        add_material(scene, diffuse({0, 1, 0}));
        const dvec3 n(0, 0, 1);
        scene.vertices = {{{0, 0, 0}, n, {0, 0.25}},
                          {{1, 0, 0}, n, {1, 0.25}},
                          {{0, 1, 0}, {0, 0.6, 0.8}, {0, 0.75}},
                          {{1, 1, 0}, n, {1, 0.75}}};
        scene.triangles = {{{0, 1, 2}, 0, 0}, {{1, 3, 2}, 1, 0}};
        return scene;
    }
};

TEST_F(ExportMesh, IsOneForEachMaterialWithItsOwnVertices) {
    const std::string text = exported(two_triangles());
    expect_part(text,
                "#declare mesh_0_0 = mesh2 {\nvertex_vectors { 3,\n<0, 0, 0>,\n<512, 0, 0>,\n"
                "<0, 512, 0> }\nnormal_vectors { 3,\n<0, 0, 1>,\n<0, 0, 1>,\n<0, 0.6, 0.8> }\n"
                "face_indices { 1,\n<0, 2, 1> }\n}");
    expect_part(text,
                "#declare mesh_0_1 = mesh2 {\nvertex_vectors { 3,\n<512, 0, 0>,\n<512, 512, 0>,\n"
                "<0, 512, 0> }");
    expect_part(text, "object { mesh_0_0 texture { material_0 } hollow }");
    expect_part(text, "object { mesh_0_1 texture { material_1 } hollow }");
}

TEST_F(ExportMesh, TextureCoordinatesGoUp) {
    Scene scene = two_triangles();
    scene.textures.push_back(texture_of(1, 1, {255, 255, 255, 255}));
    scene.materials[0].texture = 0;
    const std::string text = exported(scene);
    expect_part(text, "uv_vectors { 3,\n<0, 0.75>,\n<1, 0.75>,\n<0, 0.25> }");
    EXPECT_EQ(text.find("uv_vectors"), text.rfind("uv_vectors")) << "one material has no texture";
}

// The material's colour times the vertex's; each corner of a face names the texture of its vertex.
TEST_F(ExportMesh, ColorsOfVerticesAreTexturesToBlend) {
    Scene scene = two_triangles();
    expect_no_part(exported(scene), "texture_list");
    scene.materials[0].color = {1, 0.5, 1};
    scene.vertices[0].color = {0.25, 0.5, 1};
    const std::string text = exported(scene);
    expect_part(text, "texture_list { 3,\ntexture { pigment { rgb <0.25, 0.25, 1> } ");
    expect_part(text, "face_indices { 1,\n<0, 2, 1>, 0, 2, 1 }");
    EXPECT_EQ(text.find("texture_list"), text.rfind("texture_list")) << "one is white";
}

class ExportTexture : public Export {
protected:
    static Scene textured_sphere() {
        Scene scene;
        scene.textures.push_back(texture_of(2, 1, {255, 0, 51, 255, 188, 102, 0, 0}));
        Material material = diffuse({1, 0.5, 1});
        material.texture = 0;
        add_sphere(scene, {0, 0, 0}, 1, material);
        return scene;
    }
    void expect_texels(const std::vector<float> &expected) const {
        const cli::PictureFile picture = cli::read_picture_file(folder.path() / "scene_0.exr");
        ASSERT_EQ(picture.values.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_NEAR(picture.values[i], expected[i], 1e-6) << "value " << i;
        }
    }
};

// u = 3/4 - POV-Ray's, which counts from the x axis towards z.
TEST_F(ExportTexture, OfASphereIsTurnedToOurs) {
    const std::string text = exported(textured_sphere());
    expect_part(text, "uv_mapping pigment { image_map { exr \"scene_0.exr\" interpolate 2 } "
                      "scale <-1, 1, 1> translate 0.75 * x }");
    expect_part(text, "texture { sphere_material_0 }");
}

// Alpha is ignored, and nothing rounded.
TEST_F(ExportTexture, HasTexelsTimesTheColour) {
    exported(textured_sphere());
    expect_texels({1, 0, 0.2F, 188 / 255.0F, 0.2F, 0});
}

TEST_F(ExportTexture, IsDecodedAsTheStageDoes) {
    exported(textured_sphere(), {.decode = Transfer::power});
    const auto light = [](float value) { return std::pow(value, 2.2F); };
    expect_texels({1, 0, light(0.2F), light(188 / 255.0F), 0.5F * light(0.4F), 0});
}

}  // namespace
}  // namespace stagelight::pov
