// SPDX-License-Identifier: MIT
#include "scene/assimp_io.h"

#include <memory>
#include <utility>

#include <assimp/IOStream.hpp>

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

}  // namespace

Assimp::IOStream *CheckedIOSystem::Open(const char *file, const char *mode) {
    std::unique_ptr<Assimp::IOStream> opened(files_.Open(file, mode));
    return opened ? new CheckedIOStream(std::move(opened), has_failed_) : nullptr;
}

}  // namespace stagelight
