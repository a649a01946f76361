// SPDX-License-Identifier: MIT
#include "pov/pov_materials.h"

#include <algorithm>
#include <cstdint>
#include <set>

#include "image/image_io.h"
#include "scene/errors.h"

namespace stagelight::pov {
namespace {

// Light from lights alone is diffuse, of `share`.
std::string finish(double share, const std::string &more = "") {
    return fmt::format("finish {{ ambient 0 diffuse {}{} }}", share, more);
}

std::string reflection(const glm::dvec3 &color) {
    return fmt::format(" reflection {{ rgb {} }}", vector(color));
}

std::string finish_of(const Material &material) {
    switch (material.type) {
    case MaterialType::diffuse:
        return finish(1);
    case MaterialType::mirror:
        return finish(0, reflection(material.color));
    case MaterialType::glossy:
        return finish(1 - material.specularity, reflection(material.specularity * material.color));
    default:
        return finish(0, fmt::format(" reflection {{ rgb 0, rgb {} fresnel on }} conserve_energy",
                                     vector(material.color)));
    }
}

std::string pigment_of(const Material &material) {
    return fmt::format("pigment {{ rgb {}{} }}", vector(material.color),
                       material.type == MaterialType::dielectric ? " filter 1" : "");
}

std::string pigment_of(const std::string &picture, const char *placement) {
    return fmt::format("uv_mapping pigment {{ image_map {{ exr \"{}\" interpolate 2 }}{} }}",
                       picture, placement);
}

// Beer's law is that of a medium that absorbs and does nothing else. (POV-Ray's fade_power of 1000
// and more is exponential too, but leaves what is reflected inside as it was.)
std::string interior_of(const Material &material) {
    std::string media;
    if (material.absorption != glm::dvec3(0)) {
        media = fmt::format(" media {{ absorption rgb {} samples 1, 1 intervals 1 }}",
                            vector(material.absorption));
    }
    return fmt::format("interior {{ ior {}{} }}", material.ior, media);
}

}  // namespace

std::vector<std::size_t> used_materials(const Scene &scene) {
    std::set<std::size_t> used;
    const auto add = [&used](const auto &shapes) {
        for (const auto &shape : shapes) {
            used.insert(static_cast<std::size_t>(shape.material));
        }
    };
    add(scene.spheres);
    add(scene.planes);
    add(scene.triangles);
    return {used.begin(), used.end()};
}

void require_expressible(const Material &material) {
    if (material.texture != no_texture && material.type != MaterialType::diffuse) {
        throw UserError(fmt::format("{}: a texture on what reflects or refracts: POV-Ray does not "
                                    "colour that by a picture; expected a diffuse material",
                                    to_string(material.where)));
    }
    if (has_cutout(material)) {
        throw UserError(fmt::format("{}: a material with an alpha_cutoff: POV-Ray blends by alpha "
                                    "and has no threshold; leave it out to export the scene",
                                    to_string(material.where)));
    }
}

void require_expressible(const Texture &texture) {
    if (texture.wrap_u != Wrap::repeat || texture.wrap_v != Wrap::repeat) {
        throw UserError(fmt::format("{}: a texture that is clamped or mirrored: POV-Ray's repeat; "
                                    "leave wrap out to export the scene",
                                    to_string(texture.where)));
    }
}

bool has_color(const Scene &scene, const Triangle &triangle) {
    return std::ranges::any_of(triangle.vertices, [&scene](std::uint32_t vertex) {
        return scene.vertices[vertex].color != glm::dvec3(1);
    });
}

void require_expressible_colors(const Scene &scene) {
    for (const Triangle &triangle : scene.triangles) {
        const Material &material = scene.materials[static_cast<std::size_t>(triangle.material)];
        const bool is_plain =
            material.texture == no_texture && material.type != MaterialType::dielectric;
        if (!is_plain && has_color(scene, triangle)) {
            const Mesh &mesh = scene.meshes[static_cast<std::size_t>(triangle.mesh)];
            throw UserError(fmt::format("{}: colours of vertices on a texture or on glass: POV-Ray "
                                        "does not multiply them; expected another material",
                                        to_string(mesh.where)));
        }
    }
}

std::filesystem::path picture_of(const std::filesystem::path &file, std::size_t material) {
    return file.parent_path() / fmt::format("{}_{}.exr", file.stem().string(), material);
}

void write_picture(const Material &material, const Texture &texture, Transfer decode,
                   const std::filesystem::path &file) {
    Image image(texture.width, texture.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            const auto code = texture.texels[4 * i + static_cast<std::size_t>(channel)];
            image.pixels[i][channel] = static_cast<float>(material.color[channel])
                                       * stagelight::decode(decode, static_cast<float>(code) / 255);
        }
    }
    write_image(image, file, Transfer::none);
}

std::string texture_of(const Material &material) {
    return fmt::format("texture {{ {} {} }}", pigment_of(material), finish_of(material));
}

std::string declaration(const Material &material, std::size_t number) {
    std::string text = fmt::format("#declare material_{} = {}\n", number, texture_of(material));
    if (material.type == MaterialType::dielectric) {
        text += fmt::format("#declare interior_{} = {}\n", number, interior_of(material));
    }
    return text;
}

std::string declaration(const Material &material, std::size_t number, const std::string &picture) {
    // POV-Ray's u of a sphere counts from the x axis towards z; ours the other way, from behind.
    return fmt::format("#declare material_{0} = texture {{ {1} {3} }}\n"
                       "#declare sphere_material_{0} = texture {{ {2} {3} }}\n",
                       number, pigment_of(picture, ""),
                       pigment_of(picture, " scale <-1, 1, 1> translate 0.75 * x"),
                       finish_of(material));
}

// Half of what docs/shading.md has, times 2: a pattern begins anew at 1.
std::string normals_declaration(const glm::dvec3 &eye, std::size_t number) {
    return fmt::format(
        "#declare far_off = function {{ sqrt(pow(x - ({}), 2) + pow(y - ({}), 2) + pow(z - ({}), "
        "2)) }}\n"
        "#declare material_{} = texture {{ pigment {{ function {{ 0.5 - 0.05 * (1 - cos(2 * pi * "
        "far_off(x, y, z))) / (1 + pow(far_off(x, y, z), 2) / 50) }} color_map {{ [0 rgb 0] [1 rgb "
        "2] }} }} "
        "finish {{ ambient 0 emission 0.5 diffuse 1 }} }}\n",
        eye.x, eye.y, eye.z, number);
}

}  // namespace stagelight::pov
