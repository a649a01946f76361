// SPDX-License-Identifier: MIT
#include "scene/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_set>

#include <assimp/DefaultLogger.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <fmt/format.h>

#include "scene/errors.h"
#include "scene/joints.h"
#include "scene/mesh_formats.h"
#include "scene/ply_header.h"
#include "scene/ply_input.h"

namespace stagelight {

namespace {

// Assimp's warnings, kept instead of printed: some readers drop faces whose indices are out of
// range and say so nowhere else.
class Log {
public:
    Log() {
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
        Assimp::DefaultLogger::get()->attachStream(new Stream(text_), Assimp::Logger::Warn);
    }
    ~Log() { Assimp::DefaultLogger::kill(); }  // and the stream with it
    Log(const Log &) = delete;
    Log &operator=(const Log &) = delete;

    bool dropped_faces() const { return text_.find("out-of-range indices") != std::string::npos; }

private:
    struct Stream : Assimp::LogStream {
        explicit Stream(std::string &text) : text_(text) {}
        void write(const char *message) override { text_ += message; }
        std::string &text_;
    };
    std::string text_;
};

bool is_finite(const aiVector3D &vector) {
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

bool within(const aiMesh &mesh, const aiFace &face) {
    return std::all_of(face.mIndices, face.mIndices + face.mNumIndices,
                       [&](unsigned index) { return index < mesh.mNumVertices; });
}

// What is wrong with the mesh, or nothing. Asked before Assimp's own steps, which trust it.
std::string fault_of(const aiMesh &mesh) {
    if (!std::all_of(mesh.mVertices, mesh.mVertices + mesh.mNumVertices, is_finite)) {
        return fmt::format("mesh '{}' has a vertex that is not finite, expected finite positions",
                           mesh.mName.C_Str());
    }
    if (!std::all_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces,
                     [&](const aiFace &face) { return within(mesh, face); })) {
        return fmt::format("mesh '{}' has an index out of range, expected one below {}",
                           mesh.mName.C_Str(), mesh.mNumVertices);
    }
    return "";
}

// Replaces `values`, one a vertex, by one a corner.
template <typename T> void spread(T *&values, std::span<const unsigned> corners) {
    if (values) {
        auto *spread_values = new T[corners.size()];
        std::transform(corners.begin(), corners.end(), spread_values,
                       [&](unsigned vertex) { return values[vertex]; });
        delete[] values;
        values = spread_values;
    }
}

// Gives each corner of each face a vertex of its own. Assimp makes one normal a vertex, so that
// a cube whose faces share their corners would be shaded round. Equal ones are joined again when
// the mesh is placed.
void part_vertices(aiMesh &mesh) {
    std::vector<unsigned> corners;
    for (aiFace &face : std::span(mesh.mFaces, mesh.mNumFaces)) {
        for (unsigned &index : std::span(face.mIndices, face.mNumIndices)) {
            corners.push_back(index);
            index = static_cast<unsigned>(corners.size() - 1);
        }
    }
    spread(mesh.mVertices, corners);
    for (aiVector3D *&channel : mesh.mTextureCoords) {
        spread(channel, corners);
    }
    for (aiColor4D *&channel : mesh.mColors) {
        spread(channel, corners);
    }
    mesh.mNumVertices = static_cast<unsigned>(corners.size());
}

// glTF says how far each shape is taken on while nothing moves; other readers' weights mean less.
void take_shapes_on(aiMesh &mesh) {
    std::vector<aiVector3D> positions(mesh.mVertices, mesh.mVertices + mesh.mNumVertices);
    for (const aiAnimMesh *shape : std::span(mesh.mAnimMeshes, mesh.mNumAnimMeshes)) {
        if (shape->mWeight != 0 && shape->HasPositions()
            && shape->mNumVertices == mesh.mNumVertices) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                mesh.mVertices[i] += (shape->mVertices[i] - positions[i]) * shape->mWeight;
            }
        }
    }
}

// Parted vertices would leave the shapes of an animation behind; RemoveComponent has no flag for
// them.
void drop_shapes(aiMesh &mesh) {
    for (aiAnimMesh *shape : std::span(mesh.mAnimMeshes, mesh.mNumAnimMeshes)) {
        delete shape;
    }
    delete[] mesh.mAnimMeshes;
    mesh.mAnimMeshes = nullptr;
    mesh.mNumAnimMeshes = 0;
}

// #region import_steps
// What hangs on vertices and is no use to a still picture.
constexpr int removed = aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_BONEWEIGHTS;

constexpr unsigned steps = aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType
                           | aiProcess_GenSmoothNormals | aiProcess_FlipUVs;
// #endregion import_steps

int integer(const aiMetadata &metadata, const char *key, int otherwise) {
    std::int32_t value = 0;
    return metadata.Get(key, value) ? value : otherwise;
}

// FBX says which axes go right, up and to the viewer; Assimp's reader heeds that since 5.4, with
// the unit of length in it, which here is the scene's.
void turn_upright(const aiScene &scene) {
    if (!scene.mMetaData || !scene.mRootNode) {
        return;
    }
    constexpr std::array<const char *, 3> names{"CoordAxis", "UpAxis", "FrontAxis"};
    aiMatrix4x4 upright(aiMatrix3x3(0, 0, 0, 0, 0, 0, 0, 0, 0));
    std::array<bool, 3> is_taken{};
    for (unsigned row = 0; row < 3; ++row) {
        const std::string name = names[row];
        const int axis = integer(*scene.mMetaData, name.c_str(), static_cast<int>(row));
        const int sign = integer(*scene.mMetaData, (name + "Sign").c_str(), 1);
        if (axis < 0 || axis > 2 || is_taken[static_cast<unsigned>(axis)]) {
            return;
        }
        is_taken[static_cast<unsigned>(axis)] = true;
        upright[row][axis] = sign < 0 ? -1.0F : 1.0F;
    }
    scene.mRootNode->mTransformation = upright;
}

constexpr unsigned points_and_lines = aiPrimitiveType_POINT | aiPrimitiveType_LINE;

// One for each place that a vertex is at.
std::size_t count_places(const aiScene &scene) {
    const auto hash = [](const aiVector3D &v) {
        return std::hash<std::string_view>()({reinterpret_cast<const char *>(&v), sizeof v});
    };
    std::unordered_set<aiVector3D, decltype(hash)> places(0, hash);
    for (const aiMesh *mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
        places.insert(mesh->mVertices, mesh->mVertices + mesh->mNumVertices);
    }
    return places.size();
}

std::size_t count_used(const aiMesh &mesh) {
    std::vector<bool> is_used(mesh.mNumVertices, false);
    for (const aiFace &face : std::span(mesh.mFaces, mesh.mNumFaces)) {
        for (const unsigned index : std::span(face.mIndices, face.mNumIndices)) {
            is_used[index] = true;
        }
    }
    return static_cast<std::size_t>(std::ranges::count(is_used, true));
}

}  // namespace

// Before Assimp's own steps, which trust it.
void MeshFile::prepare() {
    const std::span meshes(scene().mMeshes, scene().mNumMeshes);
    for (aiMesh *mesh : meshes) {
        if (notes_.has_strips) {
            take_strips_apart(*mesh);
        }
        if (const std::string fault = fault_of(*mesh); !fault.empty()) {
            throw std::invalid_argument(fault);
        }
        if (notes_.is_gltf) {
            take_shapes_on(*mesh);
        }
        drop_shapes(*mesh);
    }
    if (notes_.is_fbx) {
        turn_upright(scene());
    }
    if (!pose_by_joints(scene())) {
        notes_.warnings.insert("has joints that no node moves: their meshes aren't bent");
    }
    note_what_is_lost();
    for (aiMesh *mesh : meshes) {
        if (!mesh->HasNormals()) {
            part_vertices(*mesh);
        }
    }
}

void MeshFile::note_what_is_lost() {
    const std::span meshes(scene().mMeshes, scene().mNumMeshes);
    unsigned kinds = 0;
    std::size_t corners = 0, vertices = 0, used = 0;
    for (const aiMesh *mesh : meshes) {
        for (const aiFace &face : std::span(mesh->mFaces, mesh->mNumFaces)) {
            kinds |= face.mNumIndices == 1   ? aiPrimitiveType_POINT
                     : face.mNumIndices == 2 ? aiPrimitiveType_LINE
                                             : aiPrimitiveType_TRIANGLE;
            corners += face.mNumIndices;
        }
        kinds |= mesh->mNumFaces == 0 && mesh->mNumVertices > 0 ? aiPrimitiveType_POINT : 0;
        vertices += mesh->mNumVertices;
    }
    if ((kinds & aiPrimitiveType_TRIANGLE) == 0) {
        throw std::invalid_argument(
            kinds != 0
                ? "has no triangles, only points or lines, expected a surface: programs such "
                  "as MeshLab make one of points"
                : "has no triangles, expected at least one");
    }
    if ((kinds & points_and_lines) != 0) {
        notes_.warnings.insert("its points and lines aren't drawn");
    }
    if (scene().mNumAnimations > 0) {
        notes_.warnings.insert("its animation isn't drawn, but the pose that it rests in");
    }
    if (notes_.vertices_in_file > 2 * corners) {
        vertices = notes_.vertices_in_file;
        used = count_places(scene());
    } else {
        for (const aiMesh *mesh : meshes) {
            used += count_used(*mesh);
        }
    }
    if (2 * used < vertices) {
        notes_.warnings.insert(fmt::format(
            "its faces use {} of {} vertices: the others may be points, which aren't drawn", used,
            vertices));
    }
}

MeshFile::MeshFile(const std::filesystem::path &file, const SourceLocation &where) {
    const auto refuse = [&](const std::string &what) {
        throw UserError(fmt::format("{}: {}: {}", to_string(where), file.string(), what));
    };
    if (const std::string fault = ply_fault(file); !fault.empty()) {
        refuse(fault);
    }
    Log log;
    // Edges sharper than this stay edges: between a cube's 90 degrees, which are meant, and the
    // 45 of an eight-sided column, which is meant to be round.
    importer_.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 66.0F);
    importer_.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                 aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer_.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, removed);
    importer_.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    try {
        importer_.SetIOHandler(  // it is the importer's now
            new CheckedIOSystem(file, notes_, files_));
        const bool is_read = importer_.ReadFile(file.string(), 0) != nullptr;
        if (files_.has_read_failed) {
            refuse("can't be read, expected a disk that gives all of it");
        }
        if (log.dropped_faces()) {
            refuse("has an index out of range, expected indices below the number of vertices");
        }
        const std::optional<std::string> other_format = expected_instead_of(file);
        if (other_format && (!is_read || scene().mNumMeshes == 0)) {
            refuse("can't be read, expected " + *other_format);
        }
        if (!is_read
            && std::string_view(importer_.GetErrorString()).find("Draco")
                   != std::string_view::npos) {
            refuse("requires KHR_draco_mesh_compression, which Assimp was built without, expected "
                   "plain buffers: gltf-transform copy writes them");
        }
        if (!is_read) {
            refuse(fmt::format("can't be read, expected a mesh that Assimp reads ({})",
                               importer_.GetErrorString()));
        }
        prepare();
    } catch (const std::invalid_argument &error) {
        refuse(error.what());
    }
    if (!importer_.ApplyPostProcessing(steps)) {
        refuse(fmt::format("has no triangles, expected at least one ({})",
                           importer_.GetErrorString()));
    }
}

}  // namespace stagelight
