// SPDX-License-Identifier: MIT
#include "scene/assimp_io.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include <assimp/IOStream.hpp>
#include <assimp/MemoryIOWrapper.h>

#include "scene/companion_file.h"
#include "scene/gltf_input.h"
#include "scene/mtl_input.h"
#include "scene/obj_input.h"
#include "scene/ply_input.h"
#include "scene/text.h"

namespace stagelight {
namespace {

class CheckedIOStream : public Assimp::IOStream {
public:
    CheckedIOStream(std::unique_ptr<Assimp::IOStream> file, bool &has_failed)
        : file_(std::move(file)), has_failed_(has_failed) {}

    std::size_t Read(void *buffer, std::size_t size, std::size_t count) override {
        const std::size_t got = file_->Read(buffer, size, count);
        if (got < count && size > 0 && file_->Tell() + size <= file_->FileSize()) {
            has_failed_ = true;
        }
        return got;
    }
    std::size_t Write(const void *buffer, std::size_t size, std::size_t count) override {
        return file_->Write(buffer, size, count);
    }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        return file_->Seek(offset, origin);
    }
    std::size_t Tell() const override { return file_->Tell(); }
    std::size_t FileSize() const override { return file_->FileSize(); }
    void Flush() override { file_->Flush(); }

private:
    std::unique_ptr<Assimp::IOStream> file_;
    bool &has_failed_;
};

bool is_material_library(const std::filesystem::path &file) {
    return file_extension(file) == "mtl";
}

}  // namespace

CheckedIOSystem::CheckedIOSystem(std::filesystem::path file, MeshNotes &notes, AssimpFiles &asked)
    : file_(std::move(file)), notes_(notes), asked_(asked) {
    asked_.folders = {file_.parent_path()};
    prepare(file_);
}

// What Assimp calls `file`, as it is spelled on the disk.
std::filesystem::path CheckedIOSystem::find(const std::filesystem::path &file) const {
    const std::filesystem::path &folder = asked_.folders.front();
    return file == file_
               ? file
               : find_spelled(file.lexically_relative(folder).string(), folder).value_or(file);
}

std::string CheckedIOSystem::read(const std::string &file) {
    const std::unique_ptr<Assimp::IOStream> stream(files_.Open(file.c_str(), "rb"));
    if (!stream) {
        return "";
    }
    std::string bytes(stream->FileSize(), '\0');
    const std::size_t size = stream->Read(bytes.data(), 1, bytes.size());
    asked_.has_read_failed = asked_.has_read_failed || size < bytes.size();
    bytes.resize(size);
    return bytes;
}

void CheckedIOSystem::prepare(const std::filesystem::path &file) {
    const std::string extension = file_extension(file);
    const auto serve = [&](std::optional<std::string> bytes) {
        if (bytes) {
            prepared_[file.string()] = std::move(*bytes);
        }
    };
    notes_.is_fbx = extension == "fbx";
    notes_.is_collada = extension == "dae";
    if (extension == "lxo") {
        notes_.warnings.insert(
            "is Modo's own file, which Assimp reads in part: glTF holds all of it");
    }
    if (extension == "obj") {
        is_obj_ = true;
        serve(prepared_obj(read(file.string()), notes_));
    } else if (extension == "ply") {
        serve(prepared_ply(read(file.string()), notes_));
    } else if (extension == "gltf" || extension == "glb") {
        notes_.is_gltf = true;
        const auto read_beside = [&](const std::string &name) {
            return read(find(file.parent_path() / name).string());
        };
        if (std::optional input = prepared_gltf(read(file.string()), read_beside, notes_)) {
            prepared_[std::string(converted_buffer)] = std::move(input->converted);
            serve(std::move(input->bytes));
        }
    }
}

const std::string *CheckedIOSystem::prepared(const std::string &file) const {
    auto found = prepared_.find(file);
    if (found == prepared_.end() && file.ends_with(converted_buffer)) {
        found = prepared_.find(std::string(converted_buffer));
    }
    return found == prepared_.end() ? nullptr : &found->second;
}

bool CheckedIOSystem::Exists(const char *file) const {
    return prepared(file) || files_.Exists(file);
}

Assimp::IOStream *CheckedIOSystem::Open(const char *file, const char *mode) {
    const auto open_prepared = [&](const std::string &bytes) {
        return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t *>(bytes.data()),
                                          bytes.size());
    };
    if (const std::string *bytes = prepared(file)) {
        return open_prepared(*bytes);
    }
    const std::filesystem::path found = find(file);
    std::unique_ptr<Assimp::IOStream> opened(files_.Open(found.c_str(), mode));
    if (!opened) {
        if (asked_.missing_materials.empty() && is_material_library(found)) {
            asked_.missing_materials = found.filename();
        }
        return nullptr;
    }
    if (std::ranges::find(asked_.folders, found.parent_path()) == asked_.folders.end()) {
        asked_.folders.push_back(found.parent_path());
    }
    if (is_obj_ && found != file_) {  // its materials
        return open_prepared(prepared_[file] = prepared_mtl(read(found.string()), notes_));
    }
    return new CheckedIOStream(std::move(opened), asked_.has_read_failed);
}

std::string file_extension(const std::filesystem::path &file) {
    std::string extension = lower_case(file.extension().string());
    extension.erase(0, 1);
    return extension;
}

}  // namespace stagelight
