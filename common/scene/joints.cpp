// SPDX-License-Identifier: MIT
#include "scene/joints.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/mat4x4.hpp>

#include "scene/assimp_glm.h"

namespace stagelight {
namespace {

// Up to the root, as the root sees it. Assimp's reader of MDL hangs all joints on one node, and
// lets each name its parent nevertheless.
glm::dmat4 to_root(const aiNode &node) {
    glm::dmat4 matrix(1);
    for (const aiNode *each = &node; each->mParent; each = each->mParent) {
        matrix = to_glm(each->mTransformation) * matrix;
    }
    return matrix;
}

// The first node of each name, and that places each mesh, from the root down.
struct Graph {
    explicit Graph(aiNode &root) {
        std::vector<aiNode *> open{&root};
        while (!open.empty()) {
            aiNode *node = open.back();
            open.pop_back();
            by_name.try_emplace(node->mName.C_Str(), node);
            for (const unsigned mesh : std::span(node->mMeshes, node->mNumMeshes)) {
                by_mesh.try_emplace(mesh, node);
            }
            for (unsigned i = node->mNumChildren; i-- > 0;) {
                if (node->mChildren[i]) {
                    open.push_back(node->mChildren[i]);
                }
            }
        }
    }

    std::unordered_map<std::string, aiNode *> by_name;
    std::unordered_map<unsigned, aiNode *> by_mesh;
};

void pose(aiMesh &mesh, const std::vector<glm::dmat4> &joints, const glm::dmat4 &without_joints) {
    std::vector<double> weights(mesh.mNumVertices, 0);
    std::vector<glm::dmat4> sums(mesh.mNumVertices, glm::dmat4(0));
    for (std::size_t i = 0; i < joints.size(); ++i) {
        for (const aiVertexWeight &weight :
             std::span(mesh.mBones[i]->mWeights, mesh.mBones[i]->mNumWeights)) {
            if (weight.mVertexId < mesh.mNumVertices && weight.mWeight > 0) {
                sums[weight.mVertexId] += double{weight.mWeight} * joints[i];
                weights[weight.mVertexId] += weight.mWeight;
            }
        }
    }
    for (std::size_t i = 0; i < mesh.mNumVertices; ++i) {
        const glm::dmat4 matrix = weights[i] > 0 ? sums[i] / weights[i] : without_joints;
        mesh.mVertices[i] =
            to_assimp(glm::dvec3(matrix * glm::dvec4(to_glm(mesh.mVertices[i]), 1)));
        if (mesh.HasNormals()) {
            const glm::dvec3 normal =
                glm::inverseTranspose(glm::dmat3(matrix)) * to_glm(mesh.mNormals[i]);
            const double length = glm::length(normal);
            mesh.mNormals[i] = to_assimp(length > 0 ? normal / length : normal);
        }
    }
}

void remove_mesh(aiNode &node, unsigned mesh) {
    unsigned *end = std::remove(node.mMeshes, node.mMeshes + node.mNumMeshes, mesh);
    node.mNumMeshes = static_cast<unsigned>(end - node.mMeshes);
}

void add_mesh(aiNode &node, unsigned mesh) {
    auto *meshes = new unsigned[node.mNumMeshes + 1];
    std::copy_n(node.mMeshes, node.mNumMeshes, meshes);
    meshes[node.mNumMeshes++] = mesh;
    delete[] node.mMeshes;
    node.mMeshes = meshes;
}

}  // namespace

bool pose_by_joints(const aiScene &scene) {
    const std::span meshes(scene.mMeshes, scene.mNumMeshes);
    if (!scene.mRootNode
        || std::ranges::none_of(meshes, [](const aiMesh *mesh) { return mesh->HasBones(); })) {
        return true;
    }
    const Graph graph(*scene.mRootNode);
    bool all_have_nodes = true;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        aiMesh &mesh = *scene.mMeshes[i];
        const auto holder = graph.by_mesh.find(i);
        if (!mesh.HasBones() || holder == graph.by_mesh.end()) {
            continue;
        }
        std::vector<glm::dmat4> joints;
        for (const aiBone *bone : std::span(mesh.mBones, mesh.mNumBones)) {
            const auto found = graph.by_name.find(bone->mName.C_Str());
            if (found != graph.by_name.end()) {
                joints.push_back(to_root(*found->second) * to_glm(bone->mOffsetMatrix));
            }
        }
        if (joints.size() < mesh.mNumBones) {
            all_have_nodes = false;
            continue;
        }
        pose(mesh, joints, to_root(*holder->second));
        remove_mesh(*holder->second, i);
        add_mesh(*scene.mRootNode, i);
    }
    return all_have_nodes;
}

}  // namespace stagelight
