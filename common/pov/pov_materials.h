// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "image/transfer.h"
#include "scene/scene.h"

namespace stagelight::pov {

// "<x, y, z>", every digit of it.
inline std::string vector(const glm::dvec3 &v) {
    return fmt::format("<{}, {}, {}>", v.x, v.y, v.z);
}

// The numbers of the materials that a shape uses, in order.
std::vector<std::size_t> used_materials(const Scene &scene);

// Throws UserError, with its place in the scene, for a material or texture that POV-Ray cannot
// have.
void require_expressible(const Material &material);
void require_expressible(const Texture &texture);
// The same for colours of vertices on a material that POV-Ray cannot blend.
void require_expressible_colors(const Scene &scene);

bool has_color(const Scene &scene, const Triangle &triangle);

// Where the material's texels go: beside `file`, with the number of the material.
std::filesystem::path picture_of(const std::filesystem::path &file, std::size_t material);

// Its texels as light, times its colour, which POV-Ray would not multiply.
void write_picture(const Material &material, const Texture &texture, Transfer decode,
                   const std::filesystem::path &file);

// A texture of POV-Ray's, of a material without texels.
std::string texture_of(const Material &material);
// #declare material_N, a texture of POV-Ray's, and of a dielectric interior_N.
std::string declaration(const Material &material, std::size_t number);
// Of a material with texels, which are in the file named `picture`: material_N, and
// sphere_material_N for spheres.
std::string declaration(const Material &material, std::size_t number, const std::string &picture);
// material_N as stage 01 shows it to an eye at `eye`, under lights that turn normals into colours:
// with a contour line for each unit of distance.
std::string normals_declaration(const glm::dvec3 &eye, std::size_t number);

}  // namespace stagelight::pov
