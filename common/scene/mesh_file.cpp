// SPDX-License-Identifier: MIT
#include "scene/mesh_file.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include <assimp/DefaultLogger.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <fmt/format.h>

#include "scene/errors.h"
#include "scene/ply_header.h"

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
void spread(aiVector3D *&values, std::span<const unsigned> corners) {
    if (values) {
        auto *spread_values = new aiVector3D[corners.size()];
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
    mesh.mNumVertices = static_cast<unsigned>(corners.size());
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
constexpr int removed =
    aiComponent_COLORS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_BONEWEIGHTS;

constexpr unsigned steps = aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType
                           | aiProcess_GenSmoothNormals | aiProcess_FlipUVs;
// #endregion import_steps

}  // namespace

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
    importer_.SetIOHandler(new CheckedIOSystem(file, files_));  // it is the importer's now
    const bool is_read = importer_.ReadFile(file.string(), 0) != nullptr;
    if (files_.has_read_failed) {
        refuse("can't be read, expected a disk that gives all of it");
    }
    if (log.dropped_faces()) {
        refuse("has an index out of range, expected indices below the number of vertices");
    }
    if (!is_read) {
        refuse(fmt::format("can't be read, expected a mesh that Assimp reads ({})",
                           importer_.GetErrorString()));
    }
    for (aiMesh *mesh : std::span(scene().mMeshes, scene().mNumMeshes)) {
        if (const std::string fault = fault_of(*mesh); !fault.empty()) {
            refuse(fault);
        }
        drop_shapes(*mesh);
        if (!mesh->HasNormals()) {
            part_vertices(*mesh);
        }
    }
    if (!importer_.ApplyPostProcessing(steps)) {
        refuse(fmt::format("has no triangles, expected at least one ({})",
                           importer_.GetErrorString()));
    }
}

}  // namespace stagelight
