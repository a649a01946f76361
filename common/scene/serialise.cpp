// SPDX-License-Identifier: MIT
#include "scene/serialise.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace stagelight {
namespace {

class Writer {
public:
    template <typename T> void put(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::size_t count = values.size();
        bytes.append(reinterpret_cast<const char *>(&count), sizeof count);
        bytes.append(reinterpret_cast<const char *>(values.data()), values.size_bytes());
    }
    template <typename T> void put(const T &value) { put(std::span<const T>(&value, 1)); }

    std::string bytes;
};

class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    // Appends to `values`.
    template <typename Values> void take(Values &values) {
        using T = typename Values::value_type;
        std::size_t count = 0;
        take_bytes(&count, sizeof count);
        is_sound_ = is_sound_ && count <= bytes_.size() / sizeof(T);
        if (is_sound_ && count > 0) {
            values.resize(values.size() + count);
            take_bytes(&*(values.end() - static_cast<std::ptrdiff_t>(count)), count * sizeof(T));
        }
    }
    template <typename T> T take_one() {
        std::vector<T> values;
        take(values);
        is_sound_ = is_sound_ && values.size() == 1;
        return is_sound_ ? values.front() : T{};
    }

    bool is_sound() const { return is_sound_; }
    bool is_at_end() const { return bytes_.empty(); }

private:
    void take_bytes(void *to, std::size_t size) {
        is_sound_ = is_sound_ && size <= bytes_.size();
        if (is_sound_) {
            std::memcpy(to, bytes_.data(), size);
            bytes_.remove_prefix(size);
        }
    }

    std::string_view bytes_;
    bool is_sound_ = true;
};

// Of a Material, what a mesh file has a say in.
struct FileMaterial {
    glm::dvec3 color{1, 1, 1};
    int texture = no_texture;
    double alpha_cutoff = 0;
};

bool is_below(int index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
}

bool are_sound(const Scene &scene, std::span<const Triangle> triangles) {
    return std::ranges::all_of(triangles, [&](const Triangle &triangle) {
        return is_below(triangle.material, scene.materials.size())
               && is_below(triangle.mesh, scene.meshes.size())
               && std::ranges::all_of(triangle.vertices, [&](std::uint32_t vertex) {
                      return vertex < scene.vertices.size();
                  });
    });
}

void put(Writer &writer, const Texture &texture) {
    writer.put(std::span<const char>(texture.file.native()));
    writer.put(texture.wrap_u);
    writer.put(texture.wrap_v);
    writer.put(texture.width);
    writer.put(texture.height);
    writer.put(std::span<const char>(texture.where.file));
    writer.put(texture.where.line);
    writer.put(texture.where.column);
    writer.put(std::span<const std::uint8_t>(texture.texels));
}

Texture take_texture(Reader &reader) {
    std::string file;
    Texture texture;
    reader.take(file);
    texture.file = file;
    texture.wrap_u = reader.take_one<Wrap>();
    texture.wrap_v = reader.take_one<Wrap>();
    texture.width = reader.take_one<int>();
    texture.height = reader.take_one<int>();
    reader.take(texture.where.file);
    texture.where.line = reader.take_one<unsigned>();
    texture.where.column = reader.take_one<unsigned>();
    reader.take(texture.texels);
    return texture;
}

bool is_sound(Wrap wrap) {
    return wrap == Wrap::repeat || wrap == Wrap::clamp || wrap == Wrap::mirror;
}

bool is_sound(const Texture &texture) {
    return is_sound(texture.wrap_u) && is_sound(texture.wrap_v) && texture.width > 0
           && texture.height > 0
           && texture.texels.size()
                  == std::size_t{4} * static_cast<unsigned>(texture.width)
                         * static_cast<unsigned>(texture.height);
}

}  // namespace

SceneSizes::SceneSizes(const Scene &scene)
    : materials(scene.materials.size()), vertices(scene.vertices.size()),
      triangles(scene.triangles.size()), textures(scene.textures.size()),
      warnings(scene.warnings.size()) {}

std::string serialise_since(const SceneSizes &before, const Scene &scene) {
    Writer writer;
    writer.put(std::span(scene.vertices).subspan(before.vertices));
    writer.put(std::span(scene.triangles).subspan(before.triangles));
    writer.put(scene.materials.size() - before.materials);
    for (const Material &material : std::span(scene.materials).subspan(before.materials)) {
        writer.put(FileMaterial{material.color, material.texture, material.alpha_cutoff});
    }
    writer.put(scene.textures.size() - before.textures);
    for (const Texture &texture : std::span(scene.textures).subspan(before.textures)) {
        put(writer, texture);
    }
    writer.put(scene.warnings.size() - before.warnings);
    for (const std::string &warning : std::span(scene.warnings).subspan(before.warnings)) {
        writer.put(std::span<const char>(warning));
    }
    return std::move(writer.bytes);
}

bool append_serialised(Scene &scene, std::string_view bytes, const SourceLocation &where) {
    const SceneSizes before(scene);
    Reader reader(bytes);
    reader.take(scene.vertices);
    reader.take(scene.triangles);
    bool is_whole = reader.is_sound();
    for (auto count = reader.take_one<std::size_t>(); is_whole && count > 0; --count) {
        const auto material = reader.take_one<FileMaterial>();
        scene.materials.push_back({.color = material.color,
                                   .texture = material.texture,
                                   .alpha_cutoff = material.alpha_cutoff,
                                   .where = where});
        is_whole = reader.is_sound();
    }
    for (auto count = reader.take_one<std::size_t>(); is_whole && count > 0; --count) {
        scene.textures.push_back(take_texture(reader));
        is_whole = reader.is_sound() && is_sound(scene.textures.back());
    }
    for (auto count = reader.take_one<std::size_t>(); is_whole && count > 0; --count) {
        reader.take(scene.warnings.emplace_back());
        is_whole = reader.is_sound();
    }
    return is_whole && reader.is_sound() && reader.is_at_end()
           && are_sound(scene, std::span(scene.triangles).subspan(before.triangles))
           && std::ranges::all_of(std::span(scene.materials).subspan(before.materials),
                                  [&](const Material &material) {
                                      return material.texture == no_texture
                                             || is_below(material.texture, scene.textures.size());
                                  });
}

std::string serialise(const Texture &texture) {
    Writer writer;
    put(writer, texture);
    return std::move(writer.bytes);
}

std::optional<Texture> deserialise_texture(std::string_view bytes) {
    Reader reader(bytes);
    Texture texture = take_texture(reader);
    const bool is_whole = reader.is_sound() && reader.is_at_end() && is_sound(texture);
    return is_whole ? std::optional(std::move(texture)) : std::nullopt;
}

}  // namespace stagelight
