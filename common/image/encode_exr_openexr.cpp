// SPDX-License-Identifier: MIT
#include <algorithm>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>

#include "image/encode_file.h"

namespace stagelight {
namespace {

// A file in memory, where OpenEXR goes back to fill in where the rows are.
class MemoryStream : public Imf::OStream {
public:
    MemoryStream() : Imf::OStream("") {}

    void write(const char data[], int size) override {
        const auto count = static_cast<std::size_t>(size);
        bytes_.resize(std::max(bytes_.size(), position_ + count));
        std::copy_n(data, count, bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
        position_ += count;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    const std::vector<std::uint8_t> &bytes() const { return bytes_; }

private:
    std::vector<std::uint8_t> bytes_;
    std::size_t position_ = 0;
};

}  // namespace

std::vector<std::uint8_t> encode_exr(const Image &image) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer pixels;
    std::size_t offset = 0;
    for (const char *channel : {"R", "G", "B"}) {
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
        // OpenEXR only reads what it is given.
        char *first = reinterpret_cast<char *>(const_cast<glm::vec3 *>(&image.at(0, 0))) + offset;
        pixels.insert(channel, Imf::Slice(Imf::FLOAT, first, sizeof(glm::vec3),
                                          sizeof(glm::vec3) * std::size_t(image.width)));
        offset += sizeof(float);
    }
    MemoryStream stream;
    {
        Imf::OutputFile file(stream, header, 0);
        file.setFrameBuffer(pixels);
        file.writePixels(image.height);
    }  // it is whole when the OutputFile is gone
    return stream.bytes();
}

}  // namespace stagelight
