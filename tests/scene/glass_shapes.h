// SPDX-License-Identifier: MIT
// Scenes of glass shapes, whose tables follow each other from line 9 on.
#pragma once

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/scene_file.h"
#include "scene/temporary_folder.h"

namespace stagelight {

class GlassShapes : public testing::Test {
protected:
    Scene load(const std::string &shapes) const {
        return load_scene(folder.write(
            "scene.toml", "[camera]\nposition = [0, 0, 5]\nlook_at = [0, 0, 0]\n[materials]\n"
                          "glass = {type = \"dielectric\"}\n"
                          "hard = {type = \"dielectric\", priority = 2}\n"
                          "soft = {type = \"dielectric\", priority = -1}\n"
                          "paint = {type = \"diffuse\"}\n"
                              + shapes));
    }
    TemporaryFolder folder;
};

inline std::string sphere(const std::string &center, double radius,
                          const std::string &material = "glass") {
    return fmt::format("[[spheres]]\ncenter = [{}]\nradius = {}\nmaterial = \"{}\"\n", center,
                       radius, material);
}

inline std::string plane(const std::string &normal, const std::string &point,
                         const std::string &material = "glass") {
    return fmt::format("[[planes]]\nnormal = [{}]\npoint = [{}]\nmaterial = \"{}\"\n", normal,
                       point, material);
}

inline std::string mesh(const std::string &file, const std::string &position = "0, 0, 0",
                        const std::string &material = "glass", const std::string &placing = "") {
    return fmt::format("[[meshes]]\nfile = \"{}\"\nposition = [{}]\nmaterial = \"{}\"\n{}", file,
                       position, material, placing);
}

}  // namespace stagelight
