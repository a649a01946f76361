// SPDX-License-Identifier: MIT
#include "scene/asset_path.h"

#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "scene/messages.h"
#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

const SourceLocation here{"a.toml", 3, 8};

class AssetPath : public testing::Test {
protected:
    AssetPath() { unsetenv("STAGELIGHT_ASSETS"); }
    ~AssetPath() override { unsetenv("STAGELIGHT_ASSETS"); }

    static void set_assets(const std::string &folders) {
        setenv("STAGELIGHT_ASSETS", folders.c_str(), 1);
    }
    fs::path find(const std::string &name) const {
        return find_asset(name, scene_folder, here, packages);
    }
    std::string failure(const std::string &name) const {
        return message_of([&] { find(name); });
    }
    std::string in(const std::string &name) const { return (folder.path() / name).string(); }

    TemporaryFolder folder;
    fs::path scene_folder = folder.path() / "scenes";
    std::vector<AssetPackage> packages{{"first-models", folder.path() / "first", {"monkey.blend"}},
                                       {"second-data", folder.path() / "second", {}}};
};

TEST_F(AssetPath, LooksBesideTheSceneThenInTheVariableThenInThePackages) {
    const fs::path package = folder.write("first/deep/cube.obj", "");
    const fs::path second = folder.write("assets/two/cube.obj", "");
    const fs::path first = folder.write("assets/one/cube.obj", "");
    const fs::path beside = folder.write("scenes/cube.obj", "");
    set_assets(in("nowhere") + ":" + in("assets/one") + "::" + in("assets/two"));
    EXPECT_EQ(find("cube.obj"), beside);
    fs::remove(beside);
    EXPECT_EQ(find("cube.obj"), first);
    fs::remove(first);
    EXPECT_EQ(find("cube.obj"), second);
    fs::remove(second);
    EXPECT_EQ(find("cube.obj"), package);
}

TEST_F(AssetPath, TakesSubfoldersAndParentsOfANameAsTheyAre) {
    const fs::path inner = folder.write("scenes/meshes/a.obj", "");
    const fs::path outer = folder.write("other/b.obj", "");
    EXPECT_EQ(find("meshes/a.obj"), inner);
    EXPECT_TRUE(fs::equivalent(find("../other/b.obj"), outer));
}

TEST_F(AssetPath, TakesAnAbsoluteNameAsItIs) {
    const fs::path file = folder.write("elsewhere/a.obj", "");
    EXPECT_EQ(find(file.string()), file);
    folder.write("first/b.obj", "");
    EXPECT_EQ(failure(in("elsewhere/b.obj")),
              "a.toml:3:8: no file '" + in("elsewhere/b.obj")
                  + "', expected it in that place; packages not installed that may have it: "
                    "apt-get install second-data");
}

TEST_F(AssetPath, SkipsAFolderOfThatName) {
    fs::create_directories(folder.path() / "scenes/cube.obj");
    fs::create_directories(folder.path() / "first/cube.obj");
    const fs::path file = folder.write("second/cube.obj", "");
    EXPECT_EQ(find("cube.obj"), file);
}

TEST_F(AssetPath, OfSeveralInAPackageTakesTheFirstByPath) {
    for (const char *name : {"m", "b/x", "z", "a", "k", "b/a"}) {
        folder.write(fs::path("first") / name / "cube.obj", "");
    }
    EXPECT_EQ(find("cube.obj"), folder.path() / "first/a/cube.obj");
    EXPECT_EQ(find("k/cube.obj"), folder.path() / "first/k/cube.obj");
    EXPECT_EQ(find("unknown/cube.obj"), folder.path() / "first/a/cube.obj");
}

TEST_F(AssetPath, AnotherCaseIsAnotherFile) {
    folder.write("scenes/Cube.obj", "");
    folder.write("first/CUBE.obj", "");
    EXPECT_NE(failure("cube.obj"), "");
}

TEST_F(AssetPath, NamesThePackageThatIsKnownToHaveIt) {
    EXPECT_EQ(failure("monkey.blend"),
              "a.toml:3:8: no file 'monkey.blend', expected it in " + scene_folder.string() + ", "
                  + in("first") + ", " + in("second")
                  + "; Debian's first-models has it: apt-get install first-models");
    EXPECT_EQ(failure(in("second/textures/moon.png")),
              "a.toml:3:8: no file '" + in("second/textures/moon.png")
                  + "', expected it in that place; Debian's second-data has it: "
                    "apt-get install second-data");
}

TEST_F(AssetPath, NamesThePackagesThatAreNotInstalled) {
    const std::string searched = "a.toml:3:8: no file 'x.obj', expected it in "
                                 + scene_folder.string() + ", " + in("first") + ", " + in("second");
    EXPECT_EQ(failure("x.obj"), searched
                                    + "; packages not installed that may have it: apt-get install "
                                      "first-models second-data");
    fs::create_directories(folder.path() / "first");
    fs::create_directories(folder.path() / "second");
    EXPECT_EQ(failure("x.obj"), searched);
}

TEST_F(AssetPath, NamesTheFoldersOfTheVariable) {
    set_assets("/nowhere/one:/nowhere/two");
    EXPECT_NE(failure("x.obj").find(", /nowhere/one, /nowhere/two, "), std::string::npos)
        << failure("x.obj");
}

TEST_F(AssetPath, RefusesNamesOfNothing) {
    for (const char *name : {"", ".", "..", "/", "meshes/"}) {
        EXPECT_NE(failure(name).find("no file '"), std::string::npos)
            << "the name is '" << name << "'";
    }
}

TEST_F(AssetPath, SceneInTheWorkingFolder) {
    const fs::path before = fs::current_path();
    folder.write("scenes/cube.obj", "");
    fs::current_path(scene_folder);
    const fs::path found = find_asset("cube.obj", "", here, packages);
    const bool is_there = fs::exists(found);
    fs::current_path(before);
    EXPECT_TRUE(is_there) << found;
}

TEST_F(AssetPath, FindsTheAssetsOfTheProjectInDebiansPackages) {
    for (const AssetPackage &package : debian_packages()) {
        if (!fs::exists(package.folder)) {
            GTEST_SKIP() << package.name << " is not installed";
        }
        for (const std::string &file : package.files) {
            EXPECT_EQ(find_asset(file, scene_folder, here).filename(), file)
                << "expected in " << package.name;
        }
    }
}

}  // namespace
}  // namespace stagelight
