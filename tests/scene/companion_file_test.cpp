// SPDX-License-Identifier: MIT
#include "scene/companion_file.h"

#include <string>

#include <gtest/gtest.h>

#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

class CompanionFile : public testing::Test {
protected:
    fs::path write(const std::string &name) const { return folder.write(name, ""); }
    // For a mesh in model/.
    std::optional<fs::path> find(const std::string &name) const {
        return find_companion(name, {folder.path() / "model"});
    }
    void expect(const std::string &name, const fs::path &file) const {
        const auto found = find(name);
        ASSERT_TRUE(found) << name;
        EXPECT_TRUE(fs::equivalent(*found, file)) << name << " is taken for " << *found;
    }

    TemporaryFolder folder;
};

TEST_F(CompanionFile, HasTheNameAsItIsBeforeTheDecodedOne) {
    fs::create_directories(folder.path() / "model");
    const fs::path decoded = write("model/a b#.png");
    expect("a%20b%23.png", decoded);
    expect("./a%20b#.png", decoded);
    const fs::path literal = write("model/a%20b%23.png");
    expect("a%20b%23.png", literal);
    EXPECT_FALSE(find("100%.png"));
    expect("100%.png", write("model/100%.png"));
}

TEST_F(CompanionFile, IsBesideThenInTexturesThenInTexturesNextToTheFolder) {
    const fs::path next = write("textures/a.png");
    write("model/deep/a.png");
    expect("a.png", next);
    const fs::path inside = write("model/textures/a.png");
    expect("a.png", inside);
    const fs::path beside = write("model/a.png");
    expect("a.png", beside);
}

TEST_F(CompanionFile, IsInAnyLetterCase) {
    const fs::path file = write("model/Art/Wood.PNG");
    expect("art/wood.png", file);
    expect("ART\\WOOD.png", file);
    const fs::path next = write("Textures/stone.Jpg");
    expect("STONE.jpg", next);
    const fs::path exact = write("model/Art/wood.png");
    expect("Art/wood.png", exact);
    expect("Art/Wood.PNG", file);
}

TEST_F(CompanionFile, OfAnotherMachineHasAsMuchOfItsPathAsThereIs) {
    const fs::path file = write("model/a.png");
    for (const char *name : {R"(C:\mine\red\a.png)", "/elsewhere/red/a.png", "../red/a.png",
                             "file:///C:/mine/red/a.png"}) {
        expect(name, file);
    }
    write("model/blue/a.png");
    const fs::path red = write("model/red/a.png");
    for (const char *name : {R"(C:\mine\red\a.png)", "/elsewhere/red/a.png", "../red/a.png"}) {
        expect(name, red);
    }
    const fs::path elsewhere = write("elsewhere/red/a.png");
    expect(elsewhere.string(), elsewhere);
}

TEST_F(CompanionFile, IsNextToTheFolderOnlyInAFolderOfItsName) {
    fs::create_directories(folder.path() / "model");
    write("a.png");
    write("blue/a.png");
    EXPECT_FALSE(find(R"(C:\mine\red\a.png)"));
    expect(R"(C:\mine\red\a.png)", write("Red/a.png"));
}

TEST_F(CompanionFile, IsInTheFoldersInTheirOrder) {
    const fs::path second = write("materials/images/a.png");
    const std::vector folders{folder.path() / "model", folder.path() / "materials"};
    fs::create_directories(folders[0]);
    EXPECT_EQ(find_companion("images/a.png", folders), second);
    const fs::path first = write("model/images/a.png");
    EXPECT_EQ(find_companion("images/a.png", folders), first);
}

TEST_F(CompanionFile, IsAtMostThreeFoldersBelowTheNearestFirst) {
    write("model/1/2/3/4/a.png");
    EXPECT_FALSE(find("a.png"));
    const fs::path third = write("model/x/2/3/a.png");
    expect("a.png", third);
    const fs::path second = write("model/z/2/A.png");
    expect("a.png", second);
    const fs::path before = write("model/y/2/A.png");
    expect("a.png", before);
    write("model/.hidden/a.png");
    expect("a.png", before);
}

TEST_F(CompanionFile, IsNotLookedForAmongThousandsOfFolders) {
    for (int i = 0; i < 101; ++i) {
        for (int k = 0; k < 100; ++k) {
            write("model/" + std::to_string(i) + "/" + std::to_string(k));
        }
    }
    write("model/0/z/a.png");
    EXPECT_FALSE(find("a.png"));
}

TEST_F(CompanionFile, IsNoFolderAndNoNameOfNothing) {
    fs::create_directories(folder.path() / "model/a.png");
    write("model/b");
    for (const char *name : {"a.png", "", ".", "..", "/", "\\", "x/..", "none.png", "b%00.png"}) {
        EXPECT_FALSE(find(name)) << name;
    }
}

TEST_F(CompanionFile, SpelledIsInItsFolderAndNowhereElse) {
    const fs::path file = write("model/My Buffer.bin");
    write("model/deep/other.bin");
    EXPECT_EQ(find_spelled("my%20buffer.bin", folder.path() / "model"), file);
    EXPECT_FALSE(find_spelled("other.bin", folder.path() / "model"));
}

}  // namespace
}  // namespace stagelight
