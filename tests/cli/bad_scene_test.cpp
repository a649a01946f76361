// SPDX-License-Identifier: MIT
// Every mistake that a scene can hold, through the program: exit code 2, one line that says where,
// and nothing written. The loader's own tests (tests/scene) cover the messages in depth.
#include <algorithm>

#include <fmt/format.h>

#include "cli/program.h"

namespace stagelight::cli {
namespace {

constexpr char mark = '^';  // stands before the place that the message is to name

struct BadScene {
    std::string name;
    std::string scene;  // what follows a good camera
    std::string text;   // of the message
};

void PrintTo(const BadScene &bad, std::ostream *stream) {
    *stream << bad.name;
}

constexpr std::string_view camera = "[camera]\nposition = [0, 1, 4]\nlook_at = [0, 0.5, 0]\n";

// "scene.toml:line:column: " of the mark, which is taken out of the text.
std::string take_place(std::string &text) {
    const auto place = std::ranges::find(text, mark);
    if (place == text.end()) {
        return "";
    }
    const auto line_start = std::find(std::reverse_iterator(place), text.rend(), '\n').base();
    const std::string where = fmt::format(
        "scene.toml:{}:{}: ", 1 + std::count(text.begin(), place, '\n'), 1 + (place - line_start));
    text.erase(place);
    return where;
}

class BadInput : public Cli, public testing::WithParamInterface<BadScene> {
protected:
    // What a scene of the table may name.
    BadInput() {
        folder.write("text.png", "no picture\n");
        folder.write("empty.obj", "");
        folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n");
        // A PNG's signature and the length of its first chunk, no more.
        folder.write("truncated.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\x0d", 12));
    }
    void expect_told(const std::string &stage) const {
        std::string text = std::string(camera) + GetParam().scene;
        const std::string place = take_place(text);
        folder.write("scene.toml", text);
        const std::vector<std::string> before = files();
        const Outcome outcome = run(stage, {"scene.toml"});
        expect_one_line(outcome, users_mistake, GetParam().text);
        expect_part(outcome.err, "error: " + place);
        EXPECT_EQ(files(), before);
    }
};

class BadInputStage01 : public BadInput {};
class BadInputStage02 : public BadInput {};
class BadInputStage05 : public BadInput {};
class BadInputStage06 : public BadInput {};

TEST_P(BadInputStage01, IsToldInOneLine) {
    expect_told("01_primitives");
}
TEST_P(BadInputStage02, IsToldInOneLine) {
    expect_told("02_shading_shadows");
}
TEST_P(BadInputStage05, IsToldInOneLine) {
    expect_told("05_meshes");
}
TEST_P(BadInputStage06, IsToldInOneLine) {
    expect_told("06_textures");
}

const auto its_name = [](const auto &bad) { return bad.param.name; };

BadScene bad_radius(const std::string &name, const std::string &radius, const std::string &text) {
    return {"radius_" + name, "[[spheres]]\ncenter = [0, 0, 0]\nradius = ^" + radius + '\n', text};
}

BadScene bad_fov(const std::string &name, const std::string &fov) {
    return {"fov_" + name, "fov = ^" + fov + '\n',
            "expected an angle above 0 and below 180 degrees"};
}

BadScene bad_size(const std::string &name, const std::string &size) {
    return {"image_" + name, "[image]\nsize = [" + size + "]\n",
            "expected a whole number from 1 to 16384"};
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, BadInputStage01,
    testing::Values(BadScene{"syntax", "[[spheres]^\n", "expected ']'"},
                    BadScene{"wrong_type", "[[spheres]]\ncenter = ^\"middle\"\nradius = 1\n",
                             "center is a string"},
                    BadScene{"unknown_key", "[[spheres]]\ncenter = [0, 0, 0]\n^radios = 1\n",
                             "unknown key 'radios'"},
                    bad_radius("nan", "nan", "radius is nan, expected a finite number"),
                    bad_radius("infinite", "inf", "radius is inf, expected a finite number"),
                    bad_radius("zero", "0", "radius is 0, expected a number above 0"),
                    bad_radius("negative", "-0.5", "radius is -0.5, expected a number above 0"),
                    BadScene{"normal_zero", "[[planes]]\npoint = [0, 0, 0]\nnormal = ^[0, 0, 0]\n",
                             "normal is zero"},
                    bad_fov("zero", "0"), bad_fov("half_turn", "180"), bad_fov("negative", "-5"),
                    bad_size("zero", "^0, 20"), bad_size("enormous", "32, ^100000")),
    its_name);

INSTANTIATE_TEST_SUITE_P(
    Scenes, BadInputStage02,
    testing::Values(BadScene{"glass",
                             "^[materials.window]\ntype = \"dielectric\"\n"
                             "[[spheres]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"window\"\n",
                             "a dielectric material: unsupported by 02_shading_shadows; "
                             "04_refraction_beer is the first stage that can draw it"},
                    BadScene{"mesh", "[[meshes]]\nfile = ^\"Suzanne_248.blend\"\n",
                             "05_meshes is the first"},
                    BadScene{"unknown_material",
                             "[[spheres]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = ^\"chalk\"\n",
                             "'chalk'"}),
    its_name);

BadScene bad_mesh(const std::string &name, const std::string &file, const std::string &text) {
    return {name, "[[meshes]]\nfile = ^\"" + file + "\"\n", text};
}

constexpr auto models = "/usr/share/assimp/models";

INSTANTIATE_TEST_SUITE_P(
    Meshes, BadInputStage05,
    testing::Values(bad_mesh("missing", "nowhere.obj", "no file 'nowhere.obj'"),
                    bad_mesh("empty", "empty.obj", "empty.obj: can't be read, expected a mesh"),
                    bad_mesh("no_triangles", "points.obj", "points.obj: has no triangles"),
                    bad_mesh("no_mesh", "text.png", "text.png: can't be read, expected a mesh"),
                    bad_mesh("invalid", "invalid.off", "invalid.off: "),
                    bad_mesh("index_out_of_range", "IndexOutOfRange.gltf", "index out of range"),
                    bad_mesh("infinite", "BoxWithInfinites.glb", "expected finite positions"),
                    bad_mesh("recursive", "RecursiveNodes.gltf", "recursive"),
                    bad_mesh("missing_part",
                             std::string(models) + "/glTF2/MissingBin/BoxTextured.gltf",
                             "BoxTextured0.bin"),
                    bad_mesh("no_scene", "NoScene.gltf", "No scene")),
    its_name);

BadScene bad_texture(const std::string &name, const std::string &file, const std::string &text) {
    return {name,
            "[materials.poster]\ntype = \"diffuse\"\ntexture = ^\"" + file
                + "\"\n[[spheres]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"poster\"\n",
            text};
}

INSTANTIATE_TEST_SUITE_P(
    Textures, BadInputStage06,
    testing::Values(bad_texture("missing", "nowhere.png", "no file 'nowhere.png'"),
                    bad_texture("truncated", "truncated.png", "truncated.png"),
                    bad_texture("no_picture", "text.png", "text.png is not a picture"),
                    BadScene{"on_a_plane",
                             "[materials.poster]\ntype = \"diffuse\"\ntexture = \"text.png\"\n"
                             "[[planes]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\n"
                             "material = ^\"poster\"\n",
                             "material 'poster' has a texture"}),
    its_name);

class Stage01SceneFile : public Cli {};

// Told at look_at, which the table has no mark for.
TEST_F(Stage01SceneFile, WithACameraAlongUpIsToldWhere) {
    folder.write("scene.toml", std::string(camera) + "up = [0, 0.5, 4]\n");
    expect_one_line(run("01_primitives", {"scene.toml"}), users_mistake,
                    "error: scene.toml:3:11: the camera looks along up");
}

TEST_F(Stage01SceneFile, ThatCannotBeReadIsToldByName) {
    const auto expect_refused = [&](const std::string &file, const std::string &text) {
        expect_one_line(run("01_primitives", {file}), users_mistake, file + ": " + text);
        EXPECT_EQ(files(), std::vector<std::string>{});
    };
    expect_refused("nowhere.toml", "can't be opened");
    expect_refused(".", "is a folder");
    expect_refused("/proc/self/mem", "can't be read");
}

}  // namespace
}  // namespace stagelight::cli
