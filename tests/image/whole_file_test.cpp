// SPDX-License-Identifier: MIT
#include "image/whole_file.h"

#include <csignal>
#include <vector>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "image/fixture.h"
#include "image/image_io.h"

namespace stagelight {
namespace {

namespace fs = std::filesystem;

// No file of this process may grow beyond `bytes`: what a disk does that is full, anywhere.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit now{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &now);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk &) = delete;
    FullDisk &operator=(const FullDisk &) = delete;

private:
    void (*handler_)(int);
    rlimit before_{};
};

// Permissions mean nothing to root, so be nobody for a while.
class NotRoot {
public:
    NotRoot() : before_(geteuid()) { failed_ = before_ == 0 && seteuid(65534) != 0; }
    ~NotRoot() {
        if (seteuid(before_) != 0) {
            std::abort();
        }
    }
    NotRoot(const NotRoot &) = delete;
    NotRoot &operator=(const NotRoot &) = delete;
    bool failed() const { return failed_; }

private:
    uid_t before_;
    bool failed_;
};

// Noise does not compress: 48 kB as a PNG, 192 kB as an EXR.
Image noise() {
    Image image(128, 128);
    std::srand(1);
    for (glm::vec3 &pixel : image.pixels) {
        for (int i = 0; i < 3; ++i) {
            pixel[i] = float(std::rand()) / float(RAND_MAX);
        }
    }
    return image;
}

class WholeFile : public InFolder {};

// A small picture fails only when its file is flushed, a large one while it is written.
TEST_F(WholeFile, FullDiskLeavesTheOldPictureAndNothingElse) {
    for (const char *name : {"a.png", "a.exr"}) {
        const Path file = folder / name;
        for (const rlim_t limit : {0U, 100U, 1000U, 4096U, 20000U, 40000U}) {
            write_bytes(file, "the old picture");
            {
                const FullDisk full(limit);
                expect_user_error([&] { write_image(noise(), file, Transfer::none); },
                                  file.string() + ": cannot be written: File too large");
            }
            EXPECT_EQ(read_bytes(file), "the old picture") << "with room for " << limit;
            EXPECT_EQ(files(), 1) << "a file was left behind with room for " << limit;
            fs::remove(file);
        }
    }
}

TEST_F(WholeFile, FullDiskStopsASmallPicture) {
    for (const char *name : {"a.png", "a.exr"}) {
        const FullDisk full(10);
        expect_user_error([&] { write_image(Image(2, 2), folder / name, Transfer::none); },
                          "File too large");
    }
    EXPECT_EQ(files(), 0) << "a file was left behind";
}

TEST_F(WholeFile, WritesTheBytesAndReplacesTheOldFile) {
    const std::vector<unsigned char> bytes = {'n', 'e', 'w', 0, '\n', 255};
    write_bytes(folder / "a", "something older and longer");
    write_whole(bytes, folder / "a");
    EXPECT_EQ(read_bytes(folder / "a"), std::string(bytes.begin(), bytes.end()));
    EXPECT_EQ(files(), 1) << "a file was left behind";
}

TEST_F(WholeFile, HasThePermissionsOfAnyNewFile) {
    const mode_t mask = umask(027);
    write_whole({}, folder / "a");
    umask(mask);
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0640));
}

TEST_F(WholeFile, RequireLeavesNothingBehind) {
    require_writable(folder / "a.png");
    EXPECT_EQ(files(), 0) << "a file was left behind";
    write_bytes(folder / "a.png", "old");
    require_writable(folder / "a.png");
    EXPECT_EQ(read_bytes(folder / "a.png"), "old");
    EXPECT_EQ(files(), 1) << "a file was left behind";
}

TEST_F(WholeFile, TheCurrentFolderNeedsNoName) {
    const Path before = fs::current_path();
    fs::current_path(folder);
    EXPECT_NO_THROW(require_writable("a.png"));
    EXPECT_NO_THROW(write_image(Image(1, 1), "a.png", Transfer::none));
    fs::current_path(before);
    EXPECT_TRUE(fs::exists(folder / "a.png"));
}

TEST_F(WholeFile, FolderThatIsNotThere) {
    const Path file = folder / "none" / "a.png";
    expect_user_error([&] { require_writable(file); },
                      "none does not exist; expected a folder that exists");
    expect_user_error([&] { write_image(Image(1, 1), file, Transfer::none); },
                      "No such file or directory");
}

TEST_F(WholeFile, FolderThatIsAFile) {
    write_bytes(folder / "file", "");
    const Path file = folder / "file" / "a.png";
    expect_user_error([&] { require_writable(file); }, "file is not a folder");
    expect_user_error([&] { write_image(Image(1, 1), file, Transfer::none); }, "Not a directory");
}

TEST_F(WholeFile, FolderThatTakesNoFiles) {
    fs::permissions(folder, fs::perms(0555));
    {
        const NotRoot nobody;
        ASSERT_FALSE(nobody.failed()) << "could not give up being root";
        expect_user_error([&] { require_writable(folder / "a.png"); },
                          folder.string() + " cannot be written to: Permission denied");
        expect_user_error([&] { write_image(Image(1, 1), folder / "a.png", Transfer::none); },
                          "cannot be written: Permission denied");
    }
    fs::permissions(folder, fs::perms(0755));
}

// As in /tmp: one may make a file, but not replace another's.
TEST_F(WholeFile, OldFileThatMayNotBeReplaced) {
    if (geteuid() != 0) {
        GTEST_SKIP() << "needs files of two owners, and so root";
    }
    fs::permissions(folder, fs::perms(01777));
    write_bytes(folder / "a.png", "the old picture");
    {
        const NotRoot nobody;
        ASSERT_FALSE(nobody.failed()) << "could not give up being root";
        expect_user_error([&] { write_image(Image(1, 1), folder / "a.png", Transfer::none); },
                          "cannot be written: Operation not permitted");
    }
    EXPECT_EQ(read_bytes(folder / "a.png"), "the old picture");
    EXPECT_EQ(files(), 1) << "a file was left behind";
}

TEST_F(WholeFile, FolderThatCannotBeSearched) {
    fs::create_directory(folder / "closed");
    fs::permissions(folder / "closed", fs::perms(0));
    {
        const NotRoot nobody;
        ASSERT_FALSE(nobody.failed()) << "could not give up being root";
        expect_user_error([&] { require_writable(folder / "closed" / "in" / "a.png"); },
                          "Permission denied");
    }
    fs::permissions(folder / "closed", fs::perms(0755));
}

// Root is not stopped by permission bits, but by a file system that has no such files.
TEST_F(WholeFile, FolderWhereEvenRootCannotWrite) {
    expect_user_error([&] { require_writable("/proc/a.png"); },
                      "the folder /proc cannot be written to");
}

TEST_F(WholeFile, TargetThatIsNoRegularFile) {
    fs::create_directory(folder / "folder.png");
    expect_user_error([&] { require_writable(folder / "folder.png"); }, "found a folder");
    expect_user_error([&] { write_image(Image(1, 1), folder / "folder.png", Transfer::none); },
                      "found a folder");

    write_bytes(folder / "real.png", "old");
    fs::create_symlink("real.png", folder / "link.png");
    expect_user_error([&] { require_writable(folder / "link.png"); }, "found a symbolic link");
    expect_user_error([&] { write_image(Image(1, 1), folder / "link.png", Transfer::none); },
                      "found a symbolic link");
    EXPECT_TRUE(fs::is_symlink(folder / "link.png")) << "the link was replaced";
    EXPECT_EQ(read_bytes(folder / "real.png"), "old");

    ASSERT_EQ(mkfifo((folder / "pipe.png").c_str(), 0600), 0);
    expect_user_error([&] { require_writable(folder / "pipe.png"); }, "found a special file");
    expect_user_error([&] { write_image(Image(1, 1), folder / "pipe.png", Transfer::none); },
                      "found a special file");
}

TEST_F(WholeFile, NameThatIsTooLong) {
    expect_user_error([&] { require_writable(folder / (std::string(300, 'a') + ".png")); },
                      "File name too long");
}

}  // namespace
}  // namespace stagelight
