// SPDX-License-Identifier: MIT
// What POV-Ray has no words for is refused with its place, and nothing is written.
#include "pov/exported.h"
#include "scene/errors.h"

namespace stagelight::pov {
namespace {

class ExportRefuses : public Export {
protected:
    void expect_refused(const Scene &scene, const std::string &message) const {
        try {
            export_pov(scene, {}, file());
            ADD_FAILURE() << "expected: " << message;
        } catch (const UserError &error) {
            expect_part(error.what(), message);
        }
        EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    }
};

TEST_F(ExportRefuses, LightsWithARange) {
    Scene scene;
    add_point_light(scene, {0, 1, 0}, {1, 1, 1}, 1);
    scene.lights[0].range = 5;
    scene.lights[0].where = {"scene.toml", 12, 1};
    expect_refused(scene, "scene.toml:12:1: a light with a range");
}

Scene textured(Material material) {
    Scene scene;
    scene.textures.push_back(texture_of(1, 1, {255, 255, 255, 255}));
    material.texture = 0;
    material.where = {"scene.toml", 7, 1};
    add_sphere(scene, {0, 0, 0}, 1, material);
    return scene;
}

TEST_F(ExportRefuses, ReflectionsColouredByAPicture) {
    const std::string message = "scene.toml:7:1: a texture on what reflects or refracts";
    expect_refused(textured(mirror({1, 1, 1})), message);
    expect_refused(textured(glossy({1, 1, 1}, 0.5)), message);
    expect_refused(textured(glass({1, 1, 1}, 1.5, {0, 0, 0})), message);
}

TEST_F(ExportRefuses, CutOutsWrapsAndColorsOnTextures) {
    Scene scene = textured(diffuse({1, 1, 1}));
    scene.textures[0].where = {"scene.toml", 9, 1};
    scene.textures[0].wrap_v = Wrap::mirror;
    expect_refused(scene, "scene.toml:9:1: a texture that is clamped or mirrored");
    scene.materials[0].alpha_cutoff = 0.5;
    expect_refused(scene, "scene.toml:7:1: a material with an alpha_cutoff");
    scene = textured(diffuse({1, 1, 1}));
    add_flat_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0);
    scene.meshes[0].where = {"scene.toml", 11, 1};
    scene.vertices[1].color = {1, 0, 0};
    expect_refused(scene, "scene.toml:11:1: colours of vertices on a texture");
}

TEST_F(ExportRefuses, NothingThatNoShapeUses) {
    Scene scene = textured(mirror({1, 1, 1}));
    scene.spheres.clear();
    expect_no_part(exported(scene), "material_0");
}

TEST_F(ExportRefuses, FoldersThatAreNotThere) {
    EXPECT_THROW(export_pov({}, {}, folder.path() / "missing" / "scene.pov"), UserError);
}

}  // namespace
}  // namespace stagelight::pov
