// SPDX-License-Identifier: MIT
#include "scene/material_table.h"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "scene/asset_path.h"
#include "scene/errors.h"
#include "scene/suggest.h"
#include "scene/texture_set.h"
#include "scene/validators.h"

namespace stagelight {
namespace {

MaterialType type_named(std::string_view name) {
    return name == "mirror"       ? MaterialType::mirror
           : name == "glossy"     ? MaterialType::glossy
           : name == "dielectric" ? MaterialType::dielectric
                                  : MaterialType::diffuse;
}

Wrap wrap_named(std::string_view name) {
    return name == "clamp" ? Wrap::clamp : name == "mirror" ? Wrap::mirror : Wrap::repeat;
}

Wraps wraps_of(const TableReader &table) {
    if (!table.has("wrap")) {
        return {};
    }
    const auto [u, v] = table.two_choices("wrap", {"repeat", "clamp", "mirror"});
    return {wrap_named(u), wrap_named(v)};
}

// Of a key that says something of it.
void require_texture(const TableReader &table, std::string_view key) {
    if (table.has(key) && !table.has("texture")) {
        throw UserError(fmt::format("{}: {} without a texture, expected a texture beside it",
                                    to_string(table.where(key)), key));
    }
}

// All but the texture.
Material read_material(const TableReader &table) {
    table.refuse_unknown({"type", "color", "texture", "wrap", "alpha_cutoff", "specularity", "ior",
                          "absorption", "priority"});
    const std::string type = table.choice("type", {"diffuse", "mirror", "glossy", "dielectric"});
    table.refuse_unless({"diffuse", "mirror", "glossy"}, type, "texture");
    table.refuse_unless({"diffuse", "mirror", "glossy"}, type, "wrap");
    table.refuse_unless({"diffuse", "mirror", "glossy"}, type, "alpha_cutoff");
    table.refuse_unless({"glossy"}, type, "specularity");
    table.refuse_unless({"dielectric"}, type, "ior");
    table.refuse_unless({"dielectric"}, type, "absorption");
    table.refuse_unless({"dielectric"}, type, "priority");
    Material material;
    material.type = type_named(type);
    material.color = table.vector("color", share, material.color);
    for (const std::string_view key : {"wrap", "alpha_cutoff"}) {
        require_texture(table, key);
    }
    material.alpha_cutoff = table.number("alpha_cutoff", share, material.alpha_cutoff);
    material.specularity = table.number("specularity", share, material.specularity);
    material.ior = table.number("ior", positive, material.ior);
    material.absorption = table.vector("absorption", not_negative, material.absorption);
    material.priority = static_cast<int>(table.number("priority", rank, material.priority));
    material.where = table.where();
    return material;
}

}  // namespace

MaterialTable::MaterialTable(Scene &scene, const TableReader &root) : scene_(&scene) {
    for (const auto &[name, table] : root.named_tables("materials")) {
        materials_.emplace(name, Named{static_cast<int>(scene.materials.size()), table});
        scene.materials.push_back(read_material(table));
        if (table.has("texture")) {
            table.text("texture");  // what it must be even where no shape uses it
            wraps_of(table);
        }
    }
}

int MaterialTable::of_shape(const TableReader &shape) {
    return shape.has("material") ? textured(named(shape)) : plain_white();
}

int MaterialTable::of_sphere(const TableReader &sphere) {
    if (sphere.has("material") && named(sphere).table.has("alpha_cutoff")) {
        throw UserError(fmt::format("{}: material '{}' has an alpha_cutoff, expected one without: "
                                    "only meshes are cut out",
                                    to_string(sphere.where("material")), sphere.text("material")));
    }
    return of_shape(sphere);
}

int MaterialTable::of_plane(const TableReader &plane) {
    if (plane.has("material") && named(plane).table.has("texture")) {
        throw UserError(fmt::format("{}: material '{}' has a texture, expected one without: a "
                                    "plane has no coordinates for it",
                                    to_string(plane.where("material")), plane.text("material")));
    }
    return of_shape(plane);
}

const MaterialTable::Named &MaterialTable::named(const TableReader &shape) const {
    const std::string name = shape.text("material");
    const auto found = materials_.find(name);
    if (found != materials_.end()) {
        return found->second;
    }
    std::vector<std::string_view> known;
    for (const auto &[known_name, material] : materials_) {
        known.push_back(known_name);
    }
    throw UserError(fmt::format("{}: unknown material '{}', {}", to_string(shape.where("material")),
                                name,
                                known.empty() ? fmt::format("expected a table [materials.{}]", name)
                                              : suggest(name, known)));
}

int MaterialTable::textured(const Named &material) {
    Material &used = scene_->materials[static_cast<std::size_t>(material.index)];
    if (used.texture == no_texture && material.table.has("texture")) {
        used.texture =
            load_texture(scene_->textures, asset_of(material.table, "texture", scene_->file),
                         material.table.where("texture"), wraps_of(material.table));
    }
    return material.index;
}

int MaterialTable::plain_white() {
    if (plain_white_ < 0) {
        plain_white_ = static_cast<int>(scene_->materials.size());
        scene_->materials.emplace_back();
    }
    return plain_white_;
}

std::filesystem::path asset_of(const TableReader &table, std::string_view key,
                               const std::filesystem::path &scene_file) {
    return find_asset(table.text(key), scene_file.parent_path(), table.where(key));
}

}  // namespace stagelight
