// SPDX-License-Identifier: MIT
#include "scene/assimp_io.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <assimp/IOStream.hpp>

#include "scene/companion_file.h"

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
    const std::string extension = file.extension();
    return extension == ".mtl" || extension == ".MTL";
}

}  // namespace

CheckedIOSystem::CheckedIOSystem(std::filesystem::path file, AssimpFiles &asked)
    : file_(std::move(file)), asked_(asked) {
    asked_.folders = {file_.parent_path()};
}

Assimp::IOStream *CheckedIOSystem::Open(const char *file, const char *mode) {
    std::filesystem::path found(file);
    const std::filesystem::path &folder = asked_.folders.front();
    if (found != file_) {
        const std::string name = found.lexically_relative(folder).string();
        found = find_spelled(name, folder).value_or(found);
    }
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
    return new CheckedIOStream(std::move(opened), asked_.has_read_failed);
}

}  // namespace stagelight
