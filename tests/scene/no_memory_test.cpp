// SPDX-License-Identifier: MIT
// Memory that ends anywhere while a scene is loaded.
#include <cstdlib>
#include <limits>
#include <new>

#include <gtest/gtest.h>

#include "scene/errors.h"
#include "scene/scene_file.h"
#include "scene/temporary_folder.h"

namespace {

long allocations_left = std::numeric_limits<long>::max();

void *allocate(std::size_t size) noexcept {
    return allocations_left-- > 0 ? std::malloc(size > 0 ? size : 1) : nullptr;
}

}  // namespace

// For the whole program, Assimp's and FreeImage's code too. Where one of a pair is inlined and the
// other is not, GCC says that the two don't match.
[[gnu::noinline]] void *operator new(std::size_t size) {
    if (void *memory = allocate(size)) {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void *operator new(std::size_t size, const std::nothrow_t &) noexcept {
    return allocate(size);
}
[[gnu::noinline]] void operator delete(void *memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void *memory, std::size_t) noexcept {
    std::free(memory);
}

namespace stagelight {
namespace {

// Whether the scene was loaded with no more than so many allocations.
bool is_loaded(const std::filesystem::path &file, long allocations) {
    bool done = false;
    allocations_left = allocations;
    try {
        load_scene(file);
        done = true;
    } catch (const UserError &) {  // the library says so of a file
    } catch (const std::bad_alloc &) {
    }
    allocations_left = std::numeric_limits<long>::max();
    return done;
}

TEST(NoMemory, IsAnErrorWhereverItEnds) {
    const TemporaryFolder folder;
    const auto scenes = std::filesystem::path(STAGELIGHT_SOURCE_DIR) / "scenes";
    for (const char *file : {"cube.obj", "cube.mtl", "cube.png"}) {
        std::filesystem::copy_file(scenes / file, folder.path() / file);
    }
    const auto scene = folder.write("scene.toml", R"([camera]
position = [3, 2, 4]
look_at = [0, 0, 0]
[materials.painted]
type = "diffuse"
texture = "cube.png"
[[spheres]]
center = [0, 0, 0]
radius = 1
material = "painted"
[[meshes]]
file = "cube.obj"
)");
    EXPECT_FALSE(is_loaded(scene, 0));
    long allocations = 1;
    while (!is_loaded(scene, allocations)) {
        allocations += 1 + allocations / 20;
        ASSERT_LT(allocations, 1'000'000);
    }
    EXPECT_GT(allocations, 100);
}

}  // namespace
}  // namespace stagelight
