// SPDX-License-Identifier: MIT
#include "scene/mesh_import.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <unistd.h>

#include "scene/assimp_glm.h"
#include "scene/errors.h"
#include "scene/mesh_file.h"
#include "scene/mesh_formats.h"
#include "scene/mesh_materials.h"
#include "scene/placed_mesh.h"
#include "scene/sandbox.h"
#include "scene/serialise.h"

namespace stagelight {

namespace {

glm::dmat4 matrix_of(const Placement &placement) {
    const glm::dvec3 angles = glm::radians(placement.rotation);
    glm::dmat4 matrix = glm::translate(glm::dmat4(1), placement.position);
    matrix = glm::rotate(matrix, angles.z, glm::dvec3(0, 0, 1));
    matrix = glm::rotate(matrix, angles.y, glm::dvec3(0, 1, 0));
    matrix = glm::rotate(matrix, angles.x, glm::dvec3(1, 0, 0));
    return glm::scale(matrix, placement.scale);
}

// Calls `visit` with each mesh that the graph places, and how. Not recursive: graphs are deep.
template <typename Visit> void for_each_placed(const aiScene &scene, const Visit &visit) {
    std::vector<std::pair<const aiNode *, glm::dmat4>> open{{scene.mRootNode, glm::dmat4(1)}};
    while (!open.empty()) {
        const auto [node, parent_to_file] = open.back();
        open.pop_back();
        if (node) {  // Assimp's reader of RAW leaves holes
            const glm::dmat4 to_file = parent_to_file * to_glm(node->mTransformation);
            for (const unsigned mesh : std::span(node->mMeshes, node->mNumMeshes)) {
                visit(*scene.mMeshes[mesh], to_file);
            }
            for (unsigned i = node->mNumChildren; i-- > 0;) {  // the first is visited first
                open.emplace_back(node->mChildren[i], to_file);
            }
        }
    }
}

// Three vertices each, their indices have 32 bits; half a vertex each, as in a grid, they fit the
// machine.
std::uint64_t most_triangles() {
    const auto memory = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES))
                        * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    return std::min<std::uint64_t>(std::numeric_limits<std::uint32_t>::max() / 3,
                                   memory / (sizeof(Triangle) + sizeof(Vertex) / 2));
}

[[noreturn]] void refuse(const std::filesystem::path &file, const SourceLocation &where,
                         const std::string &what) {
    throw UserError(fmt::format("{}: {}: {}", to_string(where), file.string(), what));
}

void require_memory_for(std::uint64_t triangles, const std::filesystem::path &file,
                        const SourceLocation &where) {
    if (triangles > most_triangles()) {
        refuse(file, where,
               fmt::format("makes {} triangles of the scene, expected at most {}, what memory and "
                           "indices hold",
                           triangles, most_triangles()));
    }
}

// Of a scene without triangles; its last mesh is to hold them. Whether all have texture
// coordinates.
bool import_here(Scene &scene, const std::filesystem::path &file, int material,
                 const SourceLocation &where) {
    const MeshFile meshes(file, where);
    allow_any_time();
    MeshMaterials materials(scene, meshes, file, where);
    if (const std::string &missing = meshes.files().missing_materials;
        material == material_of_file && !missing.empty()) {
        scene.warnings.push_back(one_line(
            fmt::format("{}: materials of {}: no file {}; its meshes are drawn in one colour",
                        to_string(where), file.string(), missing)));
    }
    std::uint64_t faces = 0;
    for_each_placed(meshes.scene(),
                    [&](const aiMesh &mesh, const glm::dmat4 &) { faces += mesh.mNumFaces; });
    require_memory_for(faces, file, where);
    bool has_coordinates = true;
    bool is_all_unseen = true;
    for_each_placed(meshes.scene(), [&](const aiMesh &mesh, const glm::dmat4 &to_file) {
        has_coordinates = has_coordinates && mesh.HasTextureCoords(0);
        const Look look =
            material == material_of_file ? materials.look_of(mesh) : Look{.material = material};
        is_all_unseen = is_all_unseen && !look.is_seen;
        if (look.is_seen && !append_placed(scene, mesh, to_file, look)) {
            refuse(file, where, "is placed out of reach, expected finite coordinates");
        }
    });
    materials.warn();
    if (is_all_unseen) {
        scene.warnings.push_back(fmt::format("{}: {}: is transparent as a whole: nothing is drawn",
                                             to_string(where), file.string()));
    } else if (scene.triangles.empty()) {
        refuse(file, where, "has no triangles, expected at least one with an area");
    }
    return has_coordinates;
}

}  // namespace

void MeshImporter::add(const std::filesystem::path &file, const Placement &placement, int material,
                       const SourceLocation &where) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        refuse(file, where, "no such file, expected a mesh");
    }
    scene_.meshes.push_back({.file = file, .where = where});
    const MeshModel &model = model_of(file, material, where);
    const bool has_own_material = material == material_of_file;
    if (!has_own_material && !model.has_texture_coordinates
        && scene_.materials[static_cast<std::size_t>(material)].texture != no_texture) {
        refuse(file, where, "has no texture coordinates, expected a material without a texture");
    }
    require_memory_for(scene_.triangles.size() + model.triangles.size(), file, where);
    const std::size_t triangles_before = scene_.triangles.size();
    if (!append_copy(scene_, model, matrix_of(placement),
                     has_own_material ? std::nullopt : std::optional(material))) {
        refuse(file, where, "is placed out of reach, expected coordinates of at most 1e18");
    }
    if (scene_.triangles.size() == triangles_before && !model.triangles.empty()) {
        refuse(file, where, "is placed without an area, expected a larger scale");
    }
}

const MeshModel &MeshImporter::model_of(const std::filesystem::path &file, int material,
                                        const SourceLocation &where) {
    const std::pair key{std::filesystem::canonical(file).string(), material == material_of_file};
    const auto known = models_.find(key);
    return known == models_.end() ? models_.emplace(key, read(file, material, where)).first->second
                                  : known->second;
}

MeshModel MeshImporter::read(const std::filesystem::path &file, int material,
                             const SourceLocation &where) {
    const std::string what = fmt::format("{}: {}", to_string(where), file.string());
    std::error_code unimportant;  // opening it will tell
    const std::string bytes = run_sandboxed(
        what, std::filesystem::file_size(file, unimportant),
        [&] {
            scene_.vertices.clear();  // in a process of its own
            scene_.triangles.clear();
            const SceneSizes before(scene_);
            const bool has_coordinates = import_here(scene_, file, material, where);
            return (has_coordinates ? '1' : '0') + serialise_since(before, scene_);
        },
        expected_instead_of(file).value_or("an undamaged file"));
    MeshModel model;
    model.has_texture_coordinates = bytes.starts_with('1');
    const auto swap_triangles = [&] {
        scene_.vertices.swap(model.vertices);
        scene_.triangles.swap(model.triangles);
    };
    swap_triangles();
    const bool is_sound =
        !bytes.empty() && append_serialised(scene_, std::string_view(bytes).substr(1), where);
    swap_triangles();
    if (!is_sound) {
        refuse(file, where, "can't be read: the reader went astray, expected another mesh");
    }
    return model;
}

}  // namespace stagelight
