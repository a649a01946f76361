// SPDX-License-Identifier: MIT
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "scene/import.h"
#include "scene/messages.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

const fs::path checker = STAGELIGHT_SOURCE_DIR "/scenes/checker.png";

constexpr const char *triangle =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";

class MeshMaterials : public testing::Test {
protected:
    // A mesh of these faces, whose materials are these.
    fs::path write_mesh(const std::string &materials, const std::string &faces) const {
        folder.write("a.mtl", materials);
        return folder.write("a.obj", triangle + faces);
    }

    TemporaryFolder folder;
};

TEST_F(MeshMaterials, TakesTheDiffuseColorWithinZeroAndOne) {
    const Scene scene = imported(write_mesh("newmtl m\nKd 1.5 -0.5 0.25\n", "usemtl m\nf 1 2 3\n"));
    ASSERT_EQ(scene.materials.size(), 1U);
    EXPECT_EQ(scene.materials[0].color, glm::dvec3(1, 0, 0.25));
    EXPECT_EQ(scene.materials[0].type, MaterialType::diffuse);
    EXPECT_EQ(scene.materials[0].texture, no_texture);
    EXPECT_EQ(to_string(scene.materials[0].where), to_string(mesh_entry));
    EXPECT_EQ(scene.triangles.at(0).material, 0);
}

TEST_F(MeshMaterials, AppendsThoseThatAreUsedOnceEach) {
    const fs::path file =
        write_mesh("newmtl red\nKd 1 0 0\nnewmtl unused\nKd 0 1 0\nnewmtl blue\nKd 0 0 1\n",
                   "usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 2\nusemtl red\nf 2 3 1\n"
                   "usemtl unused\nl 1 2\n");
    Scene scene;
    scene.materials.emplace_back();
    import_mesh(scene, file, {}, material_of_file, mesh_entry);
    ASSERT_EQ(scene.materials.size(), 3U) << "the one that was there, red and blue";
    ASSERT_EQ(scene.triangles.size(), 3U);
    int red = 0;
    for (const Triangle &each : scene.triangles) {
        ASSERT_GT(each.material, 0);
        red +=
            scene.materials[static_cast<std::size_t>(each.material)].color == glm::dvec3(1, 0, 0);
    }
    EXPECT_EQ(red, 2);
}

TEST_F(MeshMaterials, FindsTextureBesideTheMeshByAPathWithBackslashes) {
    fs::create_directories(folder.path() / "pictures");
    fs::copy(checker, folder.path() / "pictures/c.png");
    const Scene scene =
        imported(write_mesh("newmtl m\nmap_Kd pictures\\c.png\n", "usemtl m\nf 1/1 2/2 3/3\n"));
    ASSERT_EQ(scene.textures.size(), 1U);
    EXPECT_EQ(scene.textures[0].width, 8);
    EXPECT_EQ(scene.materials.at(0).texture, 0);
}

TEST_F(MeshMaterials, FindsTextureByFileNameWhenThePathIsOfAnotherMachine) {
    fs::copy(checker, folder.path() / "c.png");
    const Scene scene =
        imported(write_mesh("newmtl m\nmap_Kd D:\\art\\v2\\c.png\n", "usemtl m\nf 1/1 2/2 3/3\n"));
    EXPECT_EQ(scene.textures.size(), 1U);
}

TEST_F(MeshMaterials, LoadsASharedTextureOnce) {
    fs::copy(checker, folder.path() / "c.png");
    const fs::path file = write_mesh("newmtl m\nmap_Kd c.png\nnewmtl n\nmap_Kd ./c.png\n",
                                     "usemtl m\nf 1/1 2/2 3/3\nusemtl n\nf 1/1 3/3 2/2\n");
    Scene scene = imported(file);
    import_mesh(scene, file, {}, material_of_file, mesh_entry);
    EXPECT_EQ(scene.materials.size(), 4U) << "by two importers";
    EXPECT_EQ(scene.textures.size(), 1U);
}

TEST_F(MeshMaterials, MissingTexturesCostOneWarning) {
    const fs::path file =
        write_mesh("newmtl m\nKd 1 0.5 0\nmap_Kd none.png\nnewmtl n\nmap_Kd C:\\art\\other.png\n"
                   "newmtl o\nmap_Kd none.png\n",
                   "usemtl m\nf 1/1 2/2 3/3\nusemtl n\nf 1/1 3/3 2/2\nusemtl o\nf 2/2 1/1 3/3\n");
    const Scene scene = imported(file);
    EXPECT_EQ(scene.materials.at(0).color, glm::dvec3(1, 0.5, 0));
    EXPECT_EQ(scene.materials.at(0).texture, no_texture);
    EXPECT_EQ(scene.warnings,
              std::vector{"scene.toml:3:1: texture of " + file.string()
                          + ": no file none.png (and 1 more); the material's colour is drawn "
                            "instead"});
}

TEST_F(MeshMaterials, UnreadableTexturesCostOneWarningWithTheCause) {
    folder.write("text.png", "no picture");
    fs::copy(checker, folder.path() / "cut.png");
    fs::resize_file(folder.path() / "cut.png", 60);
    const fs::path file =
        write_mesh("newmtl m\nKd 1 0.5 0\nmap_Kd text.png\nnewmtl n\nmap_Kd cut.png\n",
                   "usemtl m\nf 1/1 2/2 3/3\nusemtl n\nf 1/1 3/3 2/2\n");
    const Scene scene = imported(file);
    EXPECT_EQ(scene.materials.at(0).texture, no_texture);
    ASSERT_EQ(scene.warnings.size(), 1U);
    const std::string &line = scene.warnings[0];
    EXPECT_EQ(line.rfind("scene.toml:3:1: texture of " + file.string() + ": ", 0), 0U) << line;
    EXPECT_NE(line.find("text.png is not a picture that can be read"), std::string::npos) << line;
    EXPECT_NE(line.find("(and 1 more); the material's colour is drawn instead"), std::string::npos)
        << line;
}

TEST_F(MeshMaterials, MissingMaterialsCostOneWarning) {
    const fs::path file =
        folder.write("a.obj", "mtllib none.mtl\nmtllib more.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                              "usemtl m\nf 1 2 3\n");
    EXPECT_EQ(imported(file).warnings,
              std::vector{"scene.toml:3:1: materials of " + file.string()
                          + ": no file none.mtl; its meshes are drawn in one colour"});
    Scene scene;
    scene.materials.emplace_back();
    import_mesh(scene, file, {}, 0, mesh_entry);
    EXPECT_TRUE(scene.warnings.empty()) << "it is drawn in the scene's material";
}

TEST_F(MeshMaterials, IsFoundInAnyLetterCaseAndTexturesBesideIt) {
    folder.write("Materials/My A.MTL", "newmtl m\nKd 0 1 0\nmap_Kd images/c.png\n");
    fs::create_directories(folder.path() / "Materials/images");
    fs::copy(checker, folder.path() / "Materials/images/c.png");
    const fs::path file =
        folder.write("a.obj", "mtllib materials/my%20a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
                              "usemtl m\nf 1/1 2/1 3/1\n");
    const Scene scene = imported(file);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
    EXPECT_EQ(scene.materials.at(0).color, glm::dvec3(0, 1, 0));
    EXPECT_EQ(scene.textures.size(), 1U);
}

TEST_F(MeshMaterials, TakesNoTextureFromTheAssetPath) {
    folder.write("assets/test.png", "");
    fs::copy_file(checker, folder.path() / "assets/test.png", fs::copy_options::overwrite_existing);
    setenv("STAGELIGHT_ASSETS", (folder.path() / "assets").c_str(), 1);
    folder.write("models/a.mtl", "newmtl m\nmap_Kd test.png\n");
    const fs::path file =
        folder.write("models/a.obj", std::string(triangle) + "usemtl m\nf 1/1 2/2 3/3\n");
    const Scene scene = imported(file);
    unsetenv("STAGELIGHT_ASSETS");
    EXPECT_TRUE(scene.textures.empty());
    EXPECT_EQ(scene.warnings.size(), 1U);
}

// Debian's assimp-testmodels has a test.png, and Assimp calls a texture of its own
// $texture_dummy.bmp.
TEST_F(MeshMaterials, NamesThatAssimpInventsAreNone) {
    const Scene scene =
        imported(write_mesh("newmtl m\nmap_Kd $texture_dummy.bmp\n", "usemtl m\nf 1/1 2/2 3/3\n"));
    EXPECT_TRUE(scene.textures.empty());
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(MeshMaterials, OfAFileThatManyEntriesNameAreReadOnce) {
    const fs::path file = write_mesh("newmtl m\nmap_Kd none.png\n", "usemtl m\nf 1/1 2/2 3/3\n");
    Scene scene;
    scene.materials.emplace_back();
    MeshImporter importer(scene);
    importer.add(file, {}, material_of_file, mesh_entry);
    importer.add(file, {.position = {5, 0, 0}}, material_of_file, {"scene.toml", 9, 1});
    importer.add(file, {.scale = glm::dvec3(-1)}, 0, {"scene.toml", 12, 1});
    EXPECT_EQ(scene.materials.size(), 2U);
    EXPECT_EQ(scene.warnings.size(), 1U) << "where it is named first";
    ASSERT_EQ(scene.meshes.size(), 3U);
    ASSERT_EQ(scene.triangles.size(), 3U);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(scene.triangles[static_cast<std::size_t>(i)].mesh, i);
    }
    EXPECT_EQ(scene.triangles[1].material, 1);
    EXPECT_EQ(scene.triangles[2].material, 0);
    EXPECT_EQ(scene.vertices.at(scene.triangles[1].vertices[1]).position, glm::dvec3(6, 0, 0));
    EXPECT_EQ(scene.vertices.at(scene.triangles[2].vertices[2]).position, glm::dvec3(-1, 0, 0))
        << "mirrored: its corners go the other way round";
}

// A file that changes while the scene is loaded is not read again.
TEST_F(MeshMaterials, ReadsAFileThatIsNamedInTwoWaysOnce) {
    const fs::path file = write_mesh("newmtl m\n", "usemtl m\nf 1 2 3\n");
    Scene scene;
    MeshImporter importer(scene);
    importer.add(file, {}, material_of_file, mesh_entry);
    folder.write("a.obj", "no longer a mesh");
    importer.add(folder.path() / "." / "a.obj", {}, material_of_file, mesh_entry);
    EXPECT_EQ(scene.triangles.size(), 2U);
    Scene another;
    EXPECT_NE(
        message_of([&] { MeshImporter(another).add(file, {}, material_of_file, mesh_entry); }), "");
}

TEST_F(MeshMaterials, NeedsNoTextureWithoutCoordinates) {
    const Scene scene =
        imported(write_mesh("newmtl m\nKd 0.5 0.5 0.5\nmap_Kd none.png\n", "usemtl m\nf 1 2 3\n"));
    EXPECT_EQ(scene.materials.at(0).texture, no_texture);
    EXPECT_EQ(scene.materials.at(0).color, glm::dvec3(0.5));
}

TEST_F(MeshMaterials, GivesWayToTheScenesMaterial) {
    const fs::path file = write_mesh("newmtl m\nmap_Kd none.png\n", "usemtl m\nf 1/1 2/2 3/3\n");
    Scene scene;
    scene.materials.resize(2);
    import_mesh(scene, file, {}, 1, mesh_entry);
    EXPECT_EQ(scene.materials.size(), 2U);
    EXPECT_TRUE(scene.textures.empty());
    EXPECT_EQ(scene.triangles.at(0).material, 1);
}

TEST_F(MeshMaterials, RefusesATexturedMaterialWithoutCoordinates) {
    const fs::path file = write_mesh("", "f 1 2 3\n");
    Scene scene;
    scene.textures.emplace_back();
    scene.materials.emplace_back().texture = 0;
    const std::string message = message_of([&] { import_mesh(scene, file, {}, 0, mesh_entry); });
    EXPECT_EQ(message.rfind("scene.toml:3:1: " + file.string() + ": has no texture coordinates", 0),
              0U)
        << message;
    EXPECT_NE(message.find("expected"), std::string::npos) << message;
}

constexpr const char *picture_inside = R"({"asset": {"version": "2.0"}, "scene": 0,
"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 0}, "material": 0}]}],
"materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.25, 0.5, 0.75, 1],
                                        "baseColorTexture": {"index": 0}}}],
"textures": [{"source": 0}], "images": [{"bufferView": 1, "mimeType": "image/png"}],
"buffers": [{"uri": "a.bin", "byteLength": LENGTH}],
"bufferViews": [{"buffer": 0, "byteLength": 36},
                {"buffer": 0, "byteOffset": 36, "byteLength": PICTURE}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
               "min": [0, 0, 0], "max": [1, 1, 0]}]})";

TEST_F(MeshMaterials, ReadsBaseColorAndAPictureInsideTheFile) {
    std::ifstream stream(checker, std::ios::binary);
    const std::string picture{std::istreambuf_iterator<char>(stream), {}};
    constexpr std::array<float, 9> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
    folder.write("a.bin",
                 std::string(reinterpret_cast<const char *>(positions.data()), sizeof positions)
                     + picture);
    std::string text = picture_inside;
    text.replace(text.find("LENGTH"), 6, std::to_string(sizeof positions + picture.size()));
    text.replace(text.find("PICTURE"), 7, std::to_string(picture.size()));
    const fs::path file = folder.write("a.gltf", text);
    Scene scene = imported(file);
    import_mesh(scene, file, {}, material_of_file, mesh_entry);
    EXPECT_EQ(scene.materials.at(0).color, glm::dvec3(0.25, 0.5, 0.75));
    ASSERT_EQ(scene.textures.size(), 1U) << "once, though the mesh is imported twice";
    EXPECT_EQ(scene.textures[0].width, 8);
    EXPECT_EQ(scene.textures[0].texels.at(0), 214) << "red of the odd corner";
    EXPECT_EQ(scene.textures[0].file, fs::canonical(file).string() + "*0");
}

TEST_F(MeshMaterials, ReadsTexelsInsideTheFile) {
    const Scene scene = imported("/usr/share/assimp/models/MDL/MDL (HL1)/alpha_test.mdl");
    ASSERT_EQ(scene.textures.size(), 1U);
    const Texture &texture = scene.textures[0];
    EXPECT_GT(texture.width, 0);
    EXPECT_EQ(texture.texels.size(),
              std::size_t{4} * static_cast<std::size_t>(texture.width * texture.height));
    EXPECT_NE(texture.texels, std::vector<std::uint8_t>(texture.texels.size(), texture.texels[0]));
}

TEST_F(MeshMaterials, ThreeOfTheProjectsOwnMesh) {
    const Scene scene = imported(STAGELIGHT_SOURCE_DIR "/scenes/materials.obj");
    ASSERT_EQ(scene.materials.size(), 3U);
    EXPECT_NEAR(scene.materials[0].color.b, 0.42, 1e-6) << "stone";
    EXPECT_NEAR(scene.materials[1].color.b, 0.76, 1e-6) << "marble";
    EXPECT_NEAR(scene.materials[2].color.b, 0.22, 1e-6) << "copper";
    EXPECT_TRUE(scene.textures.empty());
}

}  // namespace
}  // namespace stagelight
