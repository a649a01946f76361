// SPDX-License-Identifier: MIT
// A scene as its author wrote it, in double: what the device's buffers and the
// reference are both made from. Right-handed, y up; lengths in scene units,
// colours linear, angles in degrees.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace stagelight {

// Where in a file something was said; line 0 means "nowhere in the file".
struct SourceLocation {
    std::string file;
    unsigned line = 0;
    unsigned column = 0;
};

// "file:line:column", or "file" when there is no line.
std::string to_string(const SourceLocation &where);

struct CameraDescription {
    glm::dvec3 position{0, 0, 0};
    glm::dvec3 look_at{0, 0, -1};
    glm::dvec3 up{0, 1, 0};
    double fov = 60;  // degrees, horizontal, in (0, 180)

    bool operator==(const CameraDescription &) const = default;
};

enum class MaterialType { diffuse, mirror, glossy, dielectric };

constexpr int no_texture = -1;

struct Material {
    MaterialType type = MaterialType::diffuse;
    glm::dvec3 color{1, 1, 1};       // linear reflectance; a texture multiplies it
    int texture = no_texture;        // index into Scene::textures
    double specularity = 0.5;        // glossy: the share s of the reflection, [0, 1]
    double ior = 1.5;                // dielectric: index of refraction, > 0
    glm::dvec3 absorption{0, 0, 0};  // dielectric: Beer's coefficient, per scene unit
    int priority = 0;                // dielectric: the highest fills a place that several hold
    double alpha_cutoff = 0;         // where the texture's alpha is less, a triangle is not there
    SourceLocation where;
};

struct Sphere {
    glm::dvec3 center{0, 0, 0};
    double radius = 1;
    int material = 0;  // index into Scene::materials
    SourceLocation where;
};

struct Plane {
    glm::dvec3 normal{0, 1, 0};  // unit length
    glm::dvec3 point{0, 0, 0};
    int material = 0;
    SourceLocation where;
};

// World space; shared by the triangles of all meshes.
struct Vertex {
    glm::dvec3 position{0, 0, 0};
    glm::dvec3 normal{0, 0, 0};            // unit length
    glm::dvec2 texture_coordinates{0, 0};  // u to the right, v DOWN the image
    glm::dvec3 color{1, 1, 1};             // linear; multiplies the material's
};

struct Triangle {
    std::array<std::uint32_t, 3> vertices{};  // indices into Scene::vertices
    int material = 0;
    int mesh = 0;  // index into Scene::meshes
};

// One [[meshes]] entry; its geometry lies in Scene::vertices and ::triangles.
struct Mesh {
    std::filesystem::path file;
    SourceLocation where;
};

enum class LightType { point, directional };

struct Light {
    LightType type = LightType::point;
    glm::dvec3 position{0, 0, 0};    // point
    glm::dvec3 direction{0, -1, 0};  // directional: the way the light travels, unit length
    glm::dvec3 color{1, 1, 1};
    double intensity = 1;
    double range = std::numeric_limits<double>::infinity();  // point: no light beyond
    SourceLocation where;
};

// What lies beyond a picture's edges.
enum class Wrap { repeat, clamp, mirror };

// 8 bits a channel, RGBA, row 0 at the top, as the file has them (not decoded).
struct Texture {
    std::filesystem::path file;
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> texels;  // width * height * 4
    SourceLocation where;
};

struct Scene {
    std::filesystem::path file;
    int width = 640;   // pixels
    int height = 384;  // pixels
    CameraDescription camera;
    glm::dvec3 background{0, 0, 0};
    int max_depth = 8;           // bounces; 0 traces primary rays only
    bool has_max_depth = false;  // the file says it
    std::vector<Material> materials;
    std::vector<Sphere> spheres;
    std::vector<Plane> planes;
    std::vector<Mesh> meshes;
    std::vector<Vertex> vertices;
    std::vector<Triangle> triangles;
    std::vector<Light> lights;
    std::vector<Texture> textures;      // each file and way to wrap it once
    std::vector<std::string> warnings;  // about what was loaded, one line each
};

}  // namespace stagelight
