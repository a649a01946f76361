// SPDX-License-Identifier: MIT
#include "pov/pov_export.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "image/whole_file.h"
#include "pov/pov_materials.h"
#include "pov/pov_media.h"
#include "pov/pov_shapes.h"
#include "scene/dielectrics.h"
#include "scene/errors.h"

namespace stagelight {
namespace {

using pov::vector;

void require_expressible(const Light &light) {
    if (std::isfinite(light.range)) {
        throw UserError(fmt::format("{}: a light with a range: POV-Ray's lights have none; leave "
                                    "it out to export the scene",
                                    to_string(light.where)));
    }
}

// How the picture is to be asked for, since a scene does not say.
std::string head(const PovSettings &settings, const std::filesystem::path &file) {
    return fmt::format("// povray {} +W{} +H{} -A +FE -D\n"
                       "// draws this scene of Stagelight's: linear light, one ray a pixel.\n"
                       "#version 3.7;\n"
                       "global_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout 0 }}\n",
                       file.filename().string(), settings.width, settings.height,
                       settings.max_depth + 1);
}

// All vectors are given, so that it does not matter that POV-Ray's own are left-handed.
std::string camera(const CameraDescription &camera, const PovSettings &settings) {
    const glm::dvec3 forward = glm::normalize(camera.look_at - camera.position);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double width = 2 * std::tan(camera.fov * std::numbers::pi / 360);
    return fmt::format("camera {{ perspective location {} direction {} right {} up {} }}\n",
                       vector(camera.position), vector(forward), vector(width * right),
                       vector(width * settings.height / settings.width * up));
}

constexpr double far = 1e4;  // times the reach: where parallel lights stand

// How far from the origin anything is that has a place; a unit where all is there.
double reach_of(const Scene &scene) {
    double reach = glm::length(scene.camera.position);
    for (const Sphere &sphere : scene.spheres) {
        reach = std::max(reach, glm::length(sphere.center) + sphere.radius);
    }
    for (const Plane &plane : scene.planes) {
        reach = std::max(reach, std::abs(glm::dot(plane.normal, plane.point)));
    }
    for (const Vertex &vertex : scene.vertices) {
        reach = std::max(reach, glm::length(vertex.position));
    }
    return reach > 0 ? reach : 1;
}

// POV-Ray skips hits nearer than 1e-4: a ray that starts so near to the edge of a mesh leaves
// through the next face, and one that starts on a shell may miss the other. Where that is ten
// millionths of the scene, no pixel shows it. Larger than 1000, planes would end before the
// horizon, at 1e7. A power of two rounds nothing.
double enlargement(double reach) {
    return std::exp2(std::max(0.0, std::floor(std::log2(1000 / reach))));
}

// POV-Ray's light fades as 2 / (1 + (d / f)^2), f the fade_distance: where f is next to nothing
// that is 2 f^2 / d^2, which the colour makes up for. A parallel light shines from a plane on,
// which is far behind everything.
std::string light(const Light &light, double reach) {
    constexpr double near = 1e-5;  // times the reach
    const glm::dvec3 color = light.intensity * light.color;
    if (light.type == LightType::point) {
        const double fade = near * reach;
        return fmt::format("light_source {{ {} rgb {} fade_distance {} fade_power 2 "
                           "media_interaction off }}\n",
                           vector(light.position), vector(color / (2 * fade * fade)), fade);
    }
    return fmt::format("light_source {{ {} rgb {} parallel point_at 0 media_interaction off }}\n",
                       vector(-far * reach * light.direction), vector(color));
}

// Stage 01's colour of a normal, ½ + ½ N: each axis has a light that adds from its one side and one
// that takes away from the other, without shadows; the materials' emission is the ½.
std::string normal_lights(double reach) {
    std::string text;
    for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
        for (const double side : {1.0, -1.0}) {
            text += fmt::format("light_source {{ {} rgb {} parallel point_at 0 shadowless }}\n",
                                vector(side * far * reach * axis), vector(side / 2 * axis));
        }
    }
    return text;
}

// What a ray sees that meets nothing. In water without a ground it must meet something, or POV-Ray
// would not let the water absorb it.
std::string background(const Scene &scene, double reach) {
    const bool is_endless = std::ranges::any_of(
        scene.planes, [&](const Plane &plane) { return is_dielectric(scene, plane.material); });
    const std::string color = vector(scene.background);
    if (!is_endless) {
        return fmt::format("background {{ rgb {} }}\n", color);
    }
    const double distance = std::min(1e3 * reach, 1e6);  // POV-Ray sees no further than 1e7
    return fmt::format("sphere {{ {}, {} pigment {{ rgb {} }} finish {{ ambient 0 diffuse 0 "
                       "emission 1 }} hollow no_shadow inverse }}\n",
                       vector(scene.camera.position), distance, color);
}

// The declaration; of a material with a texture it writes the picture.
std::string material(const Scene &scene, std::size_t number, const PovSettings &settings,
                     const std::filesystem::path &file) {
    if (settings.shows_normals) {
        return pov::normals_declaration(scene.camera.position, number);
    }
    const Material &material = scene.materials[number];
    if (material.texture == no_texture) {
        return pov::declaration(material, number);
    }
    const std::filesystem::path picture = pov::picture_of(file, number);
    pov::write_picture(material, scene.textures[static_cast<std::size_t>(material.texture)],
                       settings.decode, picture);
    return pov::declaration(material, number, picture.filename().string());
}

}  // namespace

void export_pov(const Scene &scene, const PovSettings &settings,
                const std::filesystem::path &file) {
    const std::vector<std::size_t> used = pov::used_materials(scene);
    for (const Light &light : scene.lights) {
        require_expressible(light);
    }
    for (const std::size_t number : used) {
        const Material &material = scene.materials[number];
        pov::require_expressible(material);
        if (material.texture != no_texture) {
            pov::require_expressible(scene.textures[static_cast<std::size_t>(material.texture)]);
        }
    }
    pov::require_expressible_colors(scene);
    const pov::Media media(scene);

    const bool needs_size =
        !settings.shows_normals && (!scene.triangles.empty() || media.have_shells());
    const Scene sized = needs_size ? pov::enlarged(scene, enlargement(reach_of(scene))) : scene;
    const double reach = reach_of(sized);
    std::string text =
        head(settings, file) + camera(sized.camera, settings) + background(sized, reach);
    for (const Light &one : sized.lights) {
        text += light(one, reach);
    }
    if (settings.shows_normals) {
        text += normal_lights(reach);
    }
    for (const std::size_t number : used) {
        text += material(sized, number, settings, file);
    }
    text += pov::shapes(sized, media);
    write_whole(std::vector<unsigned char>(text.begin(), text.end()), file);
}

}  // namespace stagelight
