// SPDX-License-Identifier: MIT
// Scenes with a mistake: one line that points at it and says what was expected.
#include "scene/scene_file.h"

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/messages.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

struct Mistake {
    const char *name;
    std::string text;     // a good camera follows unless it has one
    std::string message;  // after the file's name
};

std::ostream &operator<<(std::ostream &stream, const Mistake &mistake) {
    return stream << mistake.name;
}

class SceneFileMistake : public testing::TestWithParam<Mistake> {
protected:
    TemporaryFolder folder;
};

TEST_P(SceneFileMistake, IsTold) {
    std::string text = GetParam().text;
    if (text.find("camera") == std::string::npos) {
        text += "\n[camera]\nposition = [0, 0, 4]\nlook_at = [0, 0, 0]\n";
    }
    const std::string file = folder.write("scene.toml", text).string();
    EXPECT_EQ(message_of([&] { load_scene(file); }), file + GetParam().message) << "of the scene\n"
                                                                                << text;
}

std::string name_of(const testing::TestParamInfo<Mistake> &info) {
    return info.param.name;
}

// a.a.a…
std::string dotted(int parts) {
    std::string key = "a";
    for (int i = 1; i < parts; ++i) {
        key += ".a";
    }
    return key;
}

const auto syntax = testing::Values(
    Mistake{"empty", "# camera", ":1:1: [camera] has no position, expected three numbers"},
    Mistake{"unclosed_string", "a = \"abc",
            ":1:9: Error while parsing string: unescaped control characters other than "
            "TAB (U+0009) are explicitly prohibited"},
    Mistake{"no_value", "[image]\nsize =\n",
            ":2:7: Error while parsing key-value pair: expected value, saw '\\n'"},
    Mistake{"duplicate_key", "[image]\nsize = [1, 1]\nsize = [1, 1]\n",
            ":3:8: Error while parsing key-value pair: cannot redefine existing array 'size'"},
    Mistake{"duplicate_material",
            "[materials.a]\ntype = \"diffuse\"\n[materials.a]\ntype = \"mirror\"",
            ":3:1: Error while parsing table header: cannot redefine existing table 'materials.a'"},
    Mistake{"endless_key", "[image]\n" + dotted(100000) + " = 1\n",
            ":2:1: a key of more than 1000 parts, expected a few"},
    Mistake{"too_large_for_toml", "[trace]\nmax_depth = 99999999999999999999\n",
            ":2:33: Error while parsing decimal integer: '99999999999999999999' is not "
            "representable in 64 bits"},
    Mistake{"not_utf8", "# \xFF\xFE\n", ":1:2: Encountered invalid utf-8 sequence"},
    Mistake{"binary",
            std::string("\x7f"
                        "ELF\0\1\2",
                        7),
            ":1:1: Error while parsing root table: expected keys, tables, whitespace or comments, "
            "saw '\\u007F'"},
    Mistake{"deep", "a = " + std::string(300, '['),
            ":1:261: Error while parsing value: exceeded maximum nested value depth of 256 "
            "(TOML_MAX_NESTED_VALUES)"});

const auto keys = testing::Values(
    Mistake{"unknown_table", "[[sphere]]\n",
            ":1:3: unknown key 'sphere' in the scene, did you mean 'spheres'?"},
    Mistake{"unknown_at_the_top", "fov = 3\n",
            ":1:1: unknown key 'fov' in the scene, expected one of image, camera, background, "
            "trace, materials, spheres, planes, meshes, lights"},
    Mistake{"image", "[image]\nwidth = 3\n",
            ":2:1: unknown key 'width' in [image], expected one of size"},
    Mistake{"camera", "[camera]\nlookat = [0, 0, 0]\n",
            ":2:1: unknown key 'lookat' in [camera], did you mean 'look_at'?"},
    Mistake{"background", "[background]\ncolour = [0, 0, 0]\n",
            ":2:1: unknown key 'colour' in [background], did you mean 'color'?"},
    Mistake{"trace", "[trace]\nmaxdepth = 3\n",
            ":2:1: unknown key 'maxdepth' in [trace], did you mean 'max_depth'?"},
    Mistake{"material", "[materials.a]\ntype = \"diffuse\"\n  colors = [1, 1, 1]\n",
            ":3:3: unknown key 'colors' in [materials.a], did you mean 'color'?"},
    Mistake{"sphere", "[[spheres]]\ncentre = [0, 0, 0]\nradius = 1\n",
            ":2:1: unknown key 'centre' in [[spheres]], did you mean 'center'?"},
    Mistake{"swapped_letters", "[[spheres]]\ncenter = [0, 0, 0]\nraduis = 1\n",
            ":3:1: unknown key 'raduis' in [[spheres]], did you mean 'radius'?"},
    Mistake{"not_near", "[[spheres]]\ncenter = [0, 0, 0]\nradius = 1\nshininess = 1\n",
            ":4:1: unknown key 'shininess' in [[spheres]], expected one of center, radius, "
            "material"},
    Mistake{"plane", "[[planes]]\nnormals = [0, 1, 0]\n",
            ":2:1: unknown key 'normals' in [[planes]], did you mean 'normal'?"},
    Mistake{"mesh", "[[meshes]]\nfiles = \"a\"\n",
            ":2:1: unknown key 'files' in [[meshes]], did you mean 'file'?"},
    Mistake{"light", "[[lights]]\ntype = \"point\"\npositon = [0, 0, 0]\n",
            ":3:1: unknown key 'positon' in [[lights]], did you mean 'position'?"},
    Mistake{"in_another_line_of_the_message", "\"a\\nb\" = 1\n",
            ":1:1: unknown key 'a b' in the scene, expected one of image, camera, background, "
            "trace, materials, spheres, planes, meshes, lights"});

const auto missing = testing::Values(
    Mistake{"position", "[image]\n[camera]\nlook_at = [0, 0, 0]\n",
            ":2:1: [camera] has no position, expected three numbers"},
    Mistake{"look_at", "[camera]\nposition = [0, 0, 0]\n",
            ":1:1: [camera] has no look_at, expected three numbers"},
    Mistake{"material_type", "[materials.a]\ncolor = [1, 1, 1]\n",
            ":1:1: [materials.a] has no type, expected one of diffuse, mirror, glossy, dielectric"},
    Mistake{"center", "[[spheres]]\nradius = 1\n",
            ":1:1: [[spheres]] has no center, expected three numbers"},
    Mistake{"radius", "[[spheres]]\ncenter = [0, 0, 0]\n",
            ":1:1: [[spheres]] has no radius, expected a number above 0"},
    Mistake{"normal", "[[planes]]\npoint = [0, 0, 0]\n",
            ":1:1: [[planes]] has no normal, expected three numbers"},
    Mistake{"point", "[[planes]]\nnormal = [0, 1, 0]\n",
            ":1:1: [[planes]] has no point, expected three numbers"},
    Mistake{"file", "[[meshes]]\n", ":1:1: [[meshes]] has no file, expected a string"},
    Mistake{"light_type", "[[lights]]\nposition = [0, 0, 0]\n",
            ":1:1: [[lights]] has no type, expected one of point, directional"},
    Mistake{"light_position", "[[lights]]\ntype = \"point\"\n",
            ":1:1: [[lights]] has no position, expected three numbers"},
    Mistake{"light_direction", "[[lights]]\ntype = \"directional\"\n",
            ":1:1: [[lights]] has no direction, expected three numbers"});

const auto types = testing::Values(
    Mistake{"image", "image = 3\n", ":1:9: image is 3, expected a table, [image]"},
    Mistake{"camera", "camera = true\n", ":1:10: camera is a boolean, expected a table, [camera]"},
    Mistake{"materials", "[[materials]]\n",
            ":1:1: materials is an array of 1, expected a table, [materials]"},
    Mistake{"material", "[materials]\nred = 1\n",
            ":2:7: red is 1, expected a table, [materials.red]"},
    Mistake{"spheres", "[spheres]\n",
            ":1:1: spheres is a table, expected an array of tables, [[spheres]]"},
    Mistake{"sphere", "spheres = [{center = [0, 0, 0], radius = 1}, 7]\n",
            ":1:46: spheres[1] is 7, expected a table, [[spheres]]"},
    Mistake{"size", "[image]\nsize = \"640x480\"\n",
            ":2:8: size is a string, expected two numbers"},
    Mistake{"size_of_three", "[image]\nsize = [1, 2, 3]\n",
            ":2:8: size is an array of 3, expected two numbers"},
    Mistake{"vector_of_two", "[[spheres]]\nradius = 1\ncenter = [0, 0]\n",
            ":3:10: center is an array of 2, expected three numbers"},
    Mistake{"element", "[[spheres]]\nradius = 1\ncenter = [0, 0, \"0\"]\n",
            ":3:17: center[2] is a string, expected a number"},
    Mistake{"element_after_wide_letters", "[[spheres]]\nradius = 1\ncenter = [0, \"玻璃\", 0]\n",
            ":3:14: center[1] is a string, expected a number"},
    Mistake{"number", "[[spheres]]\ncenter = [0, 0, 0]\nradius = \"1\"\n",
            ":3:10: radius is a string, expected a number above 0"},
    Mistake{"boolean", "[[spheres]]\ncenter = [0, 0, 0]\nradius = true\n",
            ":3:10: radius is a boolean, expected a number above 0"},
    Mistake{"date", "[trace]\nmax_depth = 2026-11-22\n",
            ":2:13: max_depth is a date or time, expected a whole number from 0 to 64"},
    Mistake{"material_type", "[materials.a]\ntype = 3\n", ":2:8: type is 3, expected a string"},
    Mistake{"texture", "[materials.a]\ntype = \"diffuse\"\ntexture = 3\n",
            ":3:11: texture is 3, expected a string"},
    Mistake{"material_name", "[[spheres]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = 3\n",
            ":4:12: material is 3, expected a string"},
    Mistake{"file", "[[meshes]]\nfile = [\"a\"]\n",
            ":2:8: file is an array of 1, expected a string"},
    Mistake{"scale", "[[meshes]]\nfile = \"a\"\nscale = \"2\"\n",
            ":3:9: scale is a string, expected a number other than 0"},
    Mistake{"light_type", "[[lights]]\ntype = \"spot\"\n",
            ":2:8: unknown type 'spot', expected one of point, directional"});

const auto settings =
    testing::Values(Mistake{"size_zero", "[image]\nsize = [640, 0]\n",
                            ":2:14: size[1] is 0, expected a whole number from 1 to 16384"},
                    Mistake{"size_negative", "[image]\nsize = [-640, 480]\n",
                            ":2:9: size[0] is -640, expected a whole number from 1 to 16384"},
                    Mistake{"size_enormous", "[image]\nsize = [16385, 1]\n",
                            ":2:9: size[0] is 16385, expected a whole number from 1 to 16384"},
                    Mistake{"size_fraction", "[image]\nsize = [640.5, 1]\n",
                            ":2:9: size[0] is 640.5, expected a whole number from 1 to 16384"},
                    Mistake{"background", "[background]\ncolor = [0, -0.1, 0]\n",
                            ":2:13: color[1] is -0.1, expected a number of 0 or more"},
                    Mistake{"depth_negative", "[trace]\nmax_depth = -1\n",
                            ":2:13: max_depth is -1, expected a whole number from 0 to 64"},
                    Mistake{"depth_enormous", "[trace]\nmax_depth = 65\n",
                            ":2:13: max_depth is 65, expected a whole number from 0 to 64"},
                    Mistake{"depth_fraction", "[trace]\nmax_depth = 1.5\n",
                            ":2:13: max_depth is 1.5, expected a whole number from 0 to 64"});

Mistake with_camera(const char *name, const std::string &rest, const std::string &message) {
    return {name, "[camera]\nposition = [1, 2, 3]\n" + rest, message};
}

const auto cameras = testing::Values(
    with_camera("fov_zero", "look_at = [0, 0, 0]\nfov = 0\n",
                ":4:7: fov is 0, expected an angle above 0 and below 180 degrees"),
    with_camera("fov_flat", "look_at = [0, 0, 0]\nfov = 180\n",
                ":4:7: fov is 180, expected an angle above 0 and below 180 degrees"),
    with_camera("fov_nan", "look_at = [0, 0, 0]\nfov = nan\n",
                ":4:7: fov is nan, expected a finite number, at most 1e+18 in magnitude"),
    with_camera("same_point", "look_at = [1.0, 2.0, 3.0]\n",
                ":3:11: look_at is the camera's position, expected another point"),
    with_camera("down", "look_at = [1, -2, 3]\n",
                ":3:11: the camera looks along up, expected another look_at or up"),
    with_camera("up", "look_at = [1, 3, 3]\n",
                ":3:11: the camera looks along up, expected another look_at or up"),
    with_camera("nearly_up", "up = [-1e-9, -2, -3]\nlook_at = [1, 4, 6]\n",
                ":4:11: the camera looks along up, expected another look_at or up"),
    with_camera("up_zero", "look_at = [0, 0, 0]\nup = [0, 0.0, -0.0]\n",
                ":4:6: up is zero, expected a vector with a direction"));

const std::string sphere = "[[spheres]]\ncenter = [0, 0, 0]\nradius = ";
const std::string point_light = "[[lights]]\ntype = \"point\"\nposition = [0, 0, 0]\n";

const auto shapes = testing::Values(
    Mistake{"radius_zero", sphere + "0\n", ":3:10: radius is 0, expected a number above 0"},
    Mistake{"radius_negative", sphere + "-1.5\n",
            ":3:10: radius is -1.5, expected a number above 0"},
    Mistake{"radius_infinite", sphere + "inf\n",
            ":3:10: radius is inf, expected a finite number, at most 1e+18 in magnitude"},
    Mistake{"radius_nan", sphere + "nan\n",
            ":3:10: radius is nan, expected a finite number, at most 1e+18 in magnitude"},
    Mistake{"radius_enormous", sphere + "1.1e18\n",
            ":3:10: radius is 1.1e+18, expected a finite number, at most 1e+18 in magnitude"},
    Mistake{"integer_enormous", sphere + "2000000000000000000\n",
            ":3:10: radius is 2000000000000000000, expected a finite number, at most 1e+18 in "
            "magnitude"},
    Mistake{"center_infinite", "[[spheres]]\nradius = 1\ncenter = [0, -inf, 0]\n",
            ":3:14: center[1] is -inf, expected a finite number, at most 1e+18 in magnitude"},
    Mistake{"normal_zero", "[[planes]]\npoint = [0, 0, 0]\nnormal = [0, 0, 0]\n",
            ":3:10: normal is zero, expected a vector with a direction"},
    Mistake{"normal_nan", "[[planes]]\npoint = [0, 0, 0]\nnormal = [0, nan, 0]\n",
            ":3:14: normal[1] is nan, expected a finite number, at most 1e+18 in magnitude"},
    Mistake{"scale_zero", "[[meshes]]\nfile = \"a\"\nscale = 0\n",
            ":3:9: scale is 0, expected a number other than 0"},
    Mistake{"scale_flat", "[[meshes]]\nfile = \"a\"\nscale = [1, 0, 1]\n",
            ":3:13: scale[1] is 0, expected a number other than 0"},
    Mistake{"scale_nan", "[[meshes]]\nfile = \"a\"\nscale = nan\n",
            ":3:9: scale is nan, expected a finite number, at most 1e+18 in magnitude"},
    Mistake{"rotation", "[[meshes]]\nfile = \"a\"\nrotation = 90\n",
            ":3:12: rotation is 90, expected three numbers"});

const auto lights = testing::Values(
    Mistake{"direction_zero", "[[lights]]\ntype = \"directional\"\ndirection = [0, 0, 0]\n",
            ":3:13: direction is zero, expected a vector with a direction"},
    Mistake{"color_negative", point_light + "color = [-1, 0, 0]\n",
            ":4:10: color[0] is -1, expected a number of 0 or more"},
    Mistake{"intensity_negative", point_light + "intensity = -1\n",
            ":4:13: intensity is -1, expected a number of 0 or more"},
    Mistake{"range_zero", point_light + "range = 0\n",
            ":4:9: range is 0, expected a number above 0"},
    Mistake{"range_infinite", point_light + "range = inf\n",
            ":4:9: range is inf, expected a finite number, at most 1e+18 in magnitude"},
    Mistake{"point_with_direction", point_light + "direction = [0, 1, 0]\n",
            ":4:1: direction in [[lights]], which is point: expected only with type directional"},
    Mistake{"directional_with_range",
            "[[lights]]\ntype = \"directional\"\ndirection = [0, 1, 0]\nrange = 3\n",
            ":4:1: range in [[lights]], which is directional: expected only with type point"},
    Mistake{"directional_with_position",
            "[[lights]]\ntype = \"directional\"\ndirection = [0, 1, 0]\nposition = [0, 0, 0]\n",
            ":4:1: position in [[lights]], which is directional: expected only with type point"});

Mistake with_material(const char *name, const std::string &type, const std::string &rest,
                      const std::string &message) {
    return {name, "[materials.a]\ntype = \"" + type + "\"\n" + rest + "\n", message};
}

const auto materials = testing::Values(
    with_material("type_slip", "mirorr", "", ":2:8: unknown type 'mirorr', did you mean 'mirror'?"),
    with_material("type_unknown", "metal", "",
                  ":2:8: unknown type 'metal', expected one of diffuse, mirror, glossy, "
                  "dielectric"),
    with_material("color_above_one", "diffuse", "color = [0, 0, 1.5]",
                  ":3:16: color[2] is 1.5, expected a number from 0 to 1"),
    with_material("color_negative", "diffuse", "color = [-1, 0, 0]",
                  ":3:10: color[0] is -1, expected a number from 0 to 1"),
    with_material("specularity", "glossy", "specularity = 2",
                  ":3:15: specularity is 2, expected a number from 0 to 1"),
    with_material("ior", "dielectric", "ior = 0", ":3:7: ior is 0, expected a number above 0"),
    with_material("absorption", "dielectric", "absorption = [0, 0, -1]",
                  ":3:21: absorption[2] is -1, expected a number of 0 or more"),
    with_material("priority_fraction", "dielectric", "priority = 1.5",
                  ":3:12: priority is 1.5, expected a whole number from -1000000 to 1000000"),
    with_material("priority_enormous", "dielectric", "priority = -1000001",
                  ":3:12: priority is -1000001, expected a whole number from -1000000 to 1000000"),
    with_material("priority_no_number", "dielectric", "priority = \"high\"",
                  ":3:12: priority is a string, expected a whole number from -1000000 to 1000000"),
    with_material(
        "priority_of_glossy", "glossy", "priority = 1",
        ":3:1: priority in [materials.a], which is glossy: expected only with type dielectric"),
    with_material(
        "ior_of_diffuse", "diffuse", "ior = 1.5",
        ":3:1: ior in [materials.a], which is diffuse: expected only with type dielectric"),
    with_material(
        "absorption_of_mirror", "mirror", "absorption = [1, 1, 1]",
        ":3:1: absorption in [materials.a], which is mirror: expected only with type dielectric"),
    with_material(
        "specularity_of_dielectric", "dielectric", "specularity = 1",
        ":3:1: specularity in [materials.a], which is dielectric: expected only with type glossy"),
    with_material("texture_of_dielectric", "dielectric", "texture = \"a.png\"",
                  ":3:1: texture in [materials.a], which is dielectric: expected only with type "
                  "diffuse, mirror, glossy"),
    with_material("cutoff_of_dielectric", "dielectric", "alpha_cutoff = 0.5",
                  ":3:1: alpha_cutoff in [materials.a], which is dielectric: expected only with "
                  "type diffuse, mirror, glossy"),
    with_material("cutoff_without_texture", "diffuse", "alpha_cutoff = 0.5",
                  ":3:16: alpha_cutoff without a texture, expected a texture beside it"),
    with_material("cutoff_above_one", "diffuse", "texture = \"a.png\"\nalpha_cutoff = 1.5",
                  ":4:16: alpha_cutoff is 1.5, expected a number from 0 to 1"),
    with_material("wrap_without_texture", "diffuse", "wrap = \"clamp\"",
                  ":3:8: wrap without a texture, expected a texture beside it"),
    with_material("wrap_slip", "diffuse", "texture = \"a.png\"\nwrap = \"clam\"",
                  ":4:8: unknown wrap 'clam', did you mean 'clamp'?"),
    with_material("wrap_second_slip", "diffuse",
                  "texture = \"a.png\"\nwrap = [\"clamp\", \"miror\"]",
                  ":4:18: unknown wrap[1] 'miror', did you mean 'mirror'?"),
    with_material(
        "wrap_three", "diffuse", "texture = \"a.png\"\nwrap = [\"clamp\", \"clamp\", \"clamp\"]",
        ":4:8: wrap is an array of 3, expected one or two strings of repeat, clamp, mirror"),
    with_material("wrap_of_number", "diffuse", "texture = \"a.png\"\nwrap = [1, \"clamp\"]",
                  ":4:9: wrap[0] is 1, expected one or two strings of repeat, clamp, mirror"));

const std::string glass_and_gold =
    "[materials.glass]\ntype = \"dielectric\"\n[materials.gold]\ntype = \"mirror\"\n";

const auto used_materials = testing::Values(
    Mistake{"slip", glass_and_gold + sphere + "1\nmaterial = \"glas\"\n",
            ":8:12: unknown material 'glas', did you mean 'glass'?"},
    Mistake{"not_near", glass_and_gold + sphere + "1\nmaterial = \"wood\"\n",
            ":8:12: unknown material 'wood', expected one of glass, gold"},
    Mistake{"none_there", sphere + "1\nmaterial = \"wood\"\n",
            ":4:12: unknown material 'wood', expected a table [materials.wood]"},
    Mistake{"of_a_plane",
            glass_and_gold
                + "[[planes]]\nnormal = [0, 1, 0]\npoint = [0, 0, 0]\nmaterial = \"golf\"\n",
            ":8:12: unknown material 'golf', did you mean 'gold'?"},
    Mistake{"of_a_mesh", glass_and_gold + "[[meshes]]\nfile = \"a.obj\"\nmaterial = \"class\"\n",
            ":7:12: unknown material 'class', did you mean 'glass'?"},
    Mistake{"texture_on_a_plane",
            "[materials.painted]\ntype = \"diffuse\"\ntexture = \"a.png\"\n"
            "[[planes]]\nnormal = [0, 1, 0]\npoint = [0, 0, 0]\nmaterial = \"painted\"\n",
            ":7:12: material 'painted' has a texture, expected one without: a plane has no "
            "coordinates for it"},
    Mistake{"cutoff_of_a_sphere",
            "[materials.leaf]\ntype = \"diffuse\"\ntexture = \"a.png\"\nalpha_cutoff = 0.5\n"
                + sphere + "1\nmaterial = \"leaf\"\n",
            ":8:12: material 'leaf' has an alpha_cutoff, expected one without: only meshes are "
            "cut out"});

INSTANTIATE_TEST_SUITE_P(Syntax, SceneFileMistake, syntax, name_of);
INSTANTIATE_TEST_SUITE_P(Key, SceneFileMistake, keys, name_of);
INSTANTIATE_TEST_SUITE_P(Missing, SceneFileMistake, missing, name_of);
INSTANTIATE_TEST_SUITE_P(Type, SceneFileMistake, types, name_of);
INSTANTIATE_TEST_SUITE_P(Setting, SceneFileMistake, settings, name_of);
INSTANTIATE_TEST_SUITE_P(Camera, SceneFileMistake, cameras, name_of);
INSTANTIATE_TEST_SUITE_P(Shape, SceneFileMistake, shapes, name_of);
INSTANTIATE_TEST_SUITE_P(Light, SceneFileMistake, lights, name_of);
INSTANTIATE_TEST_SUITE_P(Material, SceneFileMistake, materials, name_of);
INSTANTIATE_TEST_SUITE_P(UsedMaterial, SceneFileMistake, used_materials, name_of);

class SceneFileUnreadable : public testing::Test {
protected:
    static std::string message(const std::filesystem::path &file) {
        return message_of([&] { load_scene(file); });
    }
    TemporaryFolder folder;
};

TEST_F(SceneFileUnreadable, Missing) {
    const std::filesystem::path file = folder.path() / "none.toml";
    EXPECT_EQ(message(file), file.string()
                                 + ": can't be opened: No such file or directory, expected a "
                                   "scene in TOML");
}

TEST_F(SceneFileUnreadable, Folder) {
    EXPECT_EQ(message(folder.path()),
              folder.path().string() + ": is a folder, expected a scene in TOML");
}

TEST_F(SceneFileUnreadable, BehindAFile) {
    const std::filesystem::path file = folder.write("a", "") / "b.toml";
    EXPECT_EQ(message(file),
              file.string() + ": can't be opened: Not a directory, expected a scene in TOML");
}

TEST_F(SceneFileUnreadable, EndlessAndTooLarge) {
    EXPECT_EQ(message("/dev/zero"), "/dev/zero: is larger than 16 MiB, expected a scene in TOML");
    const std::filesystem::path file = folder.write("a.toml", std::string((16 << 20) + 1, '#'));
    EXPECT_EQ(message(file), file.string() + ": is larger than 16 MiB, expected a scene in TOML");
}

TEST_F(SceneFileUnreadable, MissingMeshAndTexturePointAtTheirNames) {
    const std::string rest = "[camera]\nposition = [0, 0, 4]\nlook_at = [0, 0, 0]\n";
    const std::string mesh =
        folder.write("mesh.toml", rest + "[[meshes]]\nfile = \"none.obj\"\n").string();
    EXPECT_EQ(message(mesh).rfind(mesh + ":5:8: no file 'none.obj', expected it in ", 0), 0U)
        << message(mesh);
    const std::string texture =
        folder
            .write("texture.toml",
                   rest + "[materials.a]\ntype = \"diffuse\"\ntexture = \"none.png\"\n" + sphere
                       + "1\nmaterial = \"a\"\n")
            .string();
    EXPECT_EQ(message(texture).rfind(texture + ":6:11: no file 'none.png', expected it in ", 0), 0U)
        << message(texture);
}

}  // namespace
}  // namespace stagelight
