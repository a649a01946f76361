// SPDX-License-Identifier: MIT
#include "scene/mesh_import.h"

#include <algorithm>
#include <cstdint>
#include <limits>
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
template <typename Visit>
void for_each_placed(const aiScene &scene, const glm::dmat4 &placing, const Visit &visit) {
    std::vector<std::pair<const aiNode *, glm::dmat4>> open{{scene.mRootNode, placing}};
    while (!open.empty()) {
        const auto [node, parent_to_world] = open.back();
        open.pop_back();
        if (node) {  // Assimp's reader of RAW leaves holes
            const glm::dmat4 to_world = parent_to_world * to_glm(node->mTransformation);
            for (const unsigned mesh : std::span(node->mMeshes, node->mNumMeshes)) {
                visit(*scene.mMeshes[mesh], to_world);
            }
            for (unsigned i = node->mNumChildren; i-- > 0;) {  // the first is visited first
                open.emplace_back(node->mChildren[i], to_world);
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

void import_here(Scene &scene, const std::filesystem::path &file, const Placement &placement,
                 int material, const SourceLocation &where) {
    const auto refuse = [&](const std::string &what) {
        throw UserError(fmt::format("{}: {}: {}", to_string(where), file.string(), what));
    };
    const MeshFile meshes(file, where);
    allow_any_time();
    MeshMaterials materials(scene, meshes, file, where);
    const bool needs_coordinates =
        material != material_of_file
        && scene.materials[static_cast<std::size_t>(material)].texture != no_texture;
    std::uint64_t faces = scene.triangles.size();
    for_each_placed(meshes.scene(), glm::dmat4(1),
                    [&](const aiMesh &mesh, const glm::dmat4 &) { faces += mesh.mNumFaces; });
    if (faces > most_triangles()) {
        refuse(fmt::format("makes {} triangles of the scene, expected at most {}, what memory and "
                           "indices hold",
                           faces, most_triangles()));
    }
    const std::size_t triangles_before = scene.triangles.size();
    scene.meshes.push_back({.file = file, .where = where});
    bool is_all_unseen = faces > scene.triangles.size();
    for_each_placed(
        meshes.scene(), matrix_of(placement), [&](const aiMesh &mesh, const glm::dmat4 &to_world) {
            if (needs_coordinates && !mesh.HasTextureCoords(0)) {
                refuse("has no texture coordinates, expected a material without a texture");
            }
            const Look look =
                material == material_of_file ? materials.look_of(mesh) : Look{.material = material};
            is_all_unseen = is_all_unseen && !look.is_seen;
            if (look.is_seen && !append_placed(scene, mesh, to_world, look)) {
                refuse("is placed out of reach, expected coordinates of at most 1e18");
            }
        });
    materials.finish();
    if (is_all_unseen) {
        scene.warnings.push_back(fmt::format("{}: {}: is transparent as a whole: nothing is drawn",
                                             to_string(where), file.string()));
        return;
    }
    if (scene.triangles.size() == triangles_before) {
        refuse("has no triangles, expected at least one with an area");
    }
}

}  // namespace

void import_mesh(Scene &scene, const std::filesystem::path &file, const Placement &placement,
                 int material, const SourceLocation &where) {
    const std::string what = fmt::format("{}: {}", to_string(where), file.string());
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        throw UserError(what + ": no such file, expected a mesh");
    }
    const std::string bytes = run_sandboxed(
        what, std::filesystem::file_size(file, error),
        [&] {
            const SceneSizes before(scene);
            import_here(scene, file, placement, material, where);
            return serialise_since(before, scene);
        },
        expected_instead_of(file).value_or("an undamaged file"));
    scene.meshes.push_back({.file = file, .where = where});
    if (!append_serialised(scene, bytes, where)) {
        throw UserError(what + ": can't be read: the reader went astray, expected another mesh");
    }
}

}  // namespace stagelight
