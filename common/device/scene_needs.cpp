// SPDX-License-Identifier: MIT
#include "device/scene_needs.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace stagelight {
namespace {

std::set<int> used_materials(const Scene &scene) {
    std::set<int> used;
    const auto use = [&used](const auto &shapes) {
        for (const auto &shape : shapes) {
            used.insert(shape.material);
        }
    };
    use(scene.spheres);
    use(scene.planes);
    use(scene.triangles);
    return used;
}

// The largest share of a ray's weight that a hit may hand on to a ray that it spawns.
double handed_on(const Material &material) {
    const double color = std::max({material.color.x, material.color.y, material.color.z});
    switch (material.type) {
    case MaterialType::diffuse:
        return 0;
    case MaterialType::glossy:
        return material.specularity * color;
    case MaterialType::mirror:
    case MaterialType::dielectric:
        break;
    }
    return color;
}

bool has_light(const Scene &scene, LightType type) {
    return std::ranges::any_of(scene.lights,
                               [type](const Light &light) { return light.type == type; });
}

bool any_mesh_material(const Scene &scene, auto is) {
    return std::ranges::any_of(scene.triangles, [&](const Triangle &triangle) {
        return is(scene.materials[static_cast<std::size_t>(triangle.material)]);
    });
}

bool has_dielectric_mesh(const Scene &scene) {
    return any_mesh_material(
        scene, [](const Material &material) { return material.type == MaterialType::dielectric; });
}

// Whether a corner's normal is off its facet's, by more than a file's rounding may put it off.
bool is_smooth(const Scene &scene, const Triangle &triangle) {
    constexpr double largest_sine = 1e-4;
    const auto corner = [&](std::size_t i) -> const Vertex & {
        return scene.vertices[triangle.vertices[i]];
    };
    const glm::dvec3 facing = glm::cross(corner(1).position - corner(0).position,
                                         corner(2).position - corner(0).position);
    return std::ranges::any_of(std::array{0, 1, 2}, [&](std::size_t i) {
        return glm::length(glm::cross(corner(i).normal, facing))
               > largest_sine * glm::length(facing);
    });
}

// Whether light meets a mesh that stands for something smooth.
bool has_smooth_mesh(const Scene &scene) {
    return std::ranges::any_of(scene.triangles, [&](const Triangle &triangle) {
        const MaterialType type = scene.materials[static_cast<std::size_t>(triangle.material)].type;
        return (type == MaterialType::diffuse || type == MaterialType::glossy)
               && is_smooth(scene, triangle);
    });
}

void add_shading_needs(SceneNeeds &needs, const Scene &scene, int max_depth, int cutoff,
                       bool smooth_shadows) {
    const std::set<int> used = used_materials(scene);
    const auto uses = [&](MaterialType type) {
        return std::ranges::any_of(used, [&](int index) {
            return scene.materials[static_cast<std::size_t>(index)].type == type;
        });
    };
    const bool dielectric = uses(MaterialType::dielectric);
    const bool glossy = uses(MaterialType::glossy);
    const bool diffuse = glossy || uses(MaterialType::diffuse);
    const bool lit = diffuse && !scene.lights.empty();
    const bool reflection = glossy || uses(MaterialType::mirror);
    // #region shading_needs
    needs.emplace_back("HAS_MATERIALS", !scene.materials.empty());
    needs.emplace_back("HAS_LIGHTS", lit);
    needs.emplace_back("HAS_POINT_LIGHT", lit && has_light(scene, LightType::point));
    needs.emplace_back("HAS_DIRECTIONAL_LIGHT", lit && has_light(scene, LightType::directional));
    needs.emplace_back("HAS_DIFFUSE", diffuse);
    needs.emplace_back("HAS_REFLECTION", reflection);
    needs.emplace_back("HAS_DIELECTRIC", dielectric);
    needs.emplace_back("HAS_DIELECTRIC_MESH", has_dielectric_mesh(scene));
    needs.emplace_back("HAS_SMOOTH_MESH", lit && smooth_shadows && has_smooth_mesh(scene));
    needs.emplace_back("HAS_TEXTURES", !scene.textures.empty());
    needs.emplace_back("HAS_MESH_TEXTURES", has_textured_mesh(scene));
    needs.emplace_back("HAS_WRAPS", has_wraps(scene));
    needs.emplace_back("HAS_CUTOUTS", has_cutouts(scene));
    needs.emplace_back("HAS_VERTEX_COLORS", has_vertex_colors(scene));
    needs.emplace_back("MAX_DEPTH", max_depth);
    needs.emplace_back("CUTOFF_ONE_IN", reflection || dielectric ? cutoff : 0);
    // Only where a ray splits in two is one left waiting, at each depth.
    needs.emplace_back("STACK_SIZE", dielectric ? max_depth + 1 : 1);
    // #endregion shading_needs
}

}  // namespace

bool has_textured_mesh(const Scene &scene) {
    return any_mesh_material(
        scene, [](const Material &material) { return material.texture != no_texture; });
}

bool has_wraps(const Scene &scene) {
    return std::ranges::any_of(scene.textures, [](const Texture &texture) {
        return texture.wrap_u != Wrap::repeat || texture.wrap_v != Wrap::repeat;
    });
}

bool has_cutouts(const Scene &scene) {
    return any_mesh_material(scene, has_cutout);
}

int depth_of(const Scene &scene, int stage) {
    constexpr int deepest = 16;
    if (stage < cutoff_stage || scene.has_max_depth) {
        return scene.max_depth;
    }
    // #region depth_of
    double share = 0;
    for (const int index : used_materials(scene)) {
        share = std::max(share, handed_on(scene.materials[static_cast<std::size_t>(index)]));
    }
    if (share >= 1) {
        return scene.max_depth;
    }
    int depth = 0;
    for (double weight = share; weight * cutoff_one_in >= 1 && depth < deepest; weight *= share) {
        ++depth;
    }
    return depth;
    // #endregion depth_of
}

int value_of(const SceneNeeds &needs, const std::string &name) {
    const auto need = std::ranges::find(needs, name, &SceneNeeds::value_type::first);
    return need == needs.end() ? 0 : need->second;
}

std::string definitions_of(const SceneNeeds &needs) {
    constexpr std::pair<const char *, int> smallest[] = {
        {"HAS_SPHERES", 0},
        {"HAS_PLANES", 0},
        {"HAS_TRIANGLES", 0},
        {"HAS_TREE", 0},
        {"HAS_MATERIALS", 0},
        {"HAS_LIGHTS", 0},
        {"HAS_POINT_LIGHT", 0},
        {"HAS_DIRECTIONAL_LIGHT", 0},
        {"HAS_REFLECTION", 0},
        {"HAS_DIELECTRIC", 0},
        {"HAS_DIELECTRIC_MESH", 0},
        {"HAS_MEDIA", 0},
        {"HAS_SMOOTH_MESH", 0},
        {"HAS_TEXTURES", 0},
        {"HAS_MESH_TEXTURES", 0},
        {"HAS_WRAPS", 0},
        {"HAS_CUTOUTS", 0},
        {"HAS_VERTEX_COLORS", 0},
        // These are numbers, not a yes or no.
        {"MAX_DEPTH", 0},
        {"CUTOFF_ONE_IN", 0},
        {"STACK_SIZE", 1},
        {"WIDTH", 1},
        {"BVH_STACK_SIZE", 1},
    };
    std::string definitions;
    for (const auto &[name, least] : smallest) {
        definitions += fmt::format(" -D {}={}", name, std::max(least, value_of(needs, name)));
    }
    return definitions;
}

SceneNeeds needs_of(const Scene &scene, int stage, int max_depth, int cutoff, bool smooth_shadows) {
    SceneNeeds needs;
    needs.emplace_back("HAS_SPHERES", !scene.spheres.empty());
    needs.emplace_back("HAS_PLANES", !scene.planes.empty());
    needs.emplace_back("HAS_TRIANGLES", !scene.triangles.empty());
    if (stage > 1) {
        const bool is_full = stage >= cutoff_stage;
        add_shading_needs(needs, scene, max_depth, is_full ? cutoff : 0, is_full && smooth_shadows);
    }
    std::erase_if(needs, [](const auto &need) {
        return need.second == 0 && need.first != "MAX_DEPTH";  // a limit, not a count
    });
    return needs;
}

}  // namespace stagelight
