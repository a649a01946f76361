// SPDX-License-Identifier: MIT
#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "budget/fingerprint.h"
#include "device/device_choice.h"
#include "implementations.h"

namespace stagelight {
namespace {

struct Asked {
    Scene scene;
    RenderSettings settings;
    std::string stage = "11_full_tracer";
    std::string device = "pocl";
};

Asked something() {
    Asked asked;
    asked.scene.spheres.push_back({.center = {0, 1, 2}, .radius = 1, .material = 0, .where = {}});
    asked.scene.materials.push_back({.where = {}});
    asked.scene.lights.push_back({.where = {}});
    asked.scene.vertices.resize(3);
    asked.scene.triangles.push_back({{0, 1, 2}, 0, 0});
    asked.scene.textures.push_back(
        {.file = {}, .width = 1, .height = 1, .texels = {1, 2, 3, 4}, .where = {}});
    return asked;
}

std::uint64_t fingerprint_of(const Asked &asked) {
    return fingerprint(choose_device(asked.device), asked.stage, asked.scene, asked.settings);
}

// Of each thing that a picture or its cost hangs on, another value is another fingerprint; of what
// neither does, it is not.
TEST(Stage11Fingerprint, TellsScenesDevicesAndSettingsApart) {
    using Change = std::function<void(Asked &)>;
    const std::vector<Change> changes{
        [](Asked &) {},
        [](Asked &it) { it.scene.spheres[0].radius = 2; },
        [](Asked &it) { it.scene.spheres[0].center.z = -2; },
        [](Asked &it) { it.scene.planes.emplace_back(); },
        [](Asked &it) { it.scene.vertices[1].position.x = 1e-300; },
        [](Asked &it) { it.scene.vertices[1].normal.x = 1; },
        [](Asked &it) { it.scene.vertices[1].texture_coordinates.y = 1; },
        [](Asked &it) {
            it.scene.triangles[0].vertices = {0, 2, 1};
        },
        [](Asked &it) { it.scene.materials[0].ior = 1.6; },
        [](Asked &it) { it.scene.materials[0].priority = 1; },
        [](Asked &it) { it.scene.materials[0].type = MaterialType::mirror; },
        [](Asked &it) { it.scene.lights[0].intensity = 2; },
        [](Asked &it) { it.scene.textures[0].texels[2] = 5; },
        [](Asked &it) { it.scene.background.y = 0.5; },
        [](Asked &it) { it.scene.camera.fov = 61; },
        [](Asked &it) { it.settings.width = 641; },
        [](Asked &it) { it.settings.max_depth = 7; },
        [](Asked &it) { it.settings.methods["math"] = "mad"; },
        [](Asked &it) { it.stage = "10_packets"; },
        [](Asked &it) { it.device = "llvmpipe"; },
    };
    std::set<std::uint64_t> found;
    for (const Change &change : changes) {
        Asked asked = something();
        change(asked);
        found.insert(fingerprint_of(asked));
    }
    EXPECT_EQ(found.size(), changes.size());
    Asked same = something();
    same.scene.file = "elsewhere.toml";
    same.scene.spheres[0].where.line = 7;
    EXPECT_EQ(fingerprint_of(same), fingerprint_of(something()));
}

}  // namespace
}  // namespace stagelight
