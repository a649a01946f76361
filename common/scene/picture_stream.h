// SPDX-License-Identifier: MIT
#pragma once

#include <istream>

#include <FreeImage.h>

namespace stagelight {

// A stream for FreeImage, which remembers whether it was asked for more than it has:
// FreeImage's own readers of BMP, PNM, TGA and JPEG fill the rest of a picture with anything.
class PictureStream {
public:
    explicit PictureStream(std::istream &stream) : stream_(stream) { rewind(); }

    // To be given to FreeImage with the address of a PictureStream as the handle.
    static FreeImageIO calls();

    void rewind();
    std::istream &stream() const { return stream_; }

    // Since it was rewound: whether a read got less than it asked for, and whether one got nothing.
    bool gave_less() const { return gave_less_; }
    bool gave_nothing() const { return gave_nothing_; }

private:
    unsigned read(void *buffer, unsigned size, unsigned count);
    bool seek(long offset, int origin);

    std::istream &stream_;
    bool gave_less_ = false;
    bool gave_nothing_ = false;
};

}  // namespace stagelight
