// SPDX-License-Identifier: MIT
#include "scene/picture_stream.h"

#include <algorithm>
#include <cstdio>

namespace stagelight {

namespace {

PictureStream &stream_of(fi_handle handle) {
    return *static_cast<PictureStream *>(handle);
}

unsigned write_nothing(void *, unsigned, unsigned, fi_handle) {
    return 0;
}

long tell(fi_handle handle) {
    return static_cast<long>(stream_of(handle).stream().tellg());
}

}  // namespace

FreeImageIO PictureStream::calls() {
    return {[](void *buffer, unsigned size, unsigned count, fi_handle handle) {
                return stream_of(handle).read(buffer, size, count);
            },
            write_nothing,
            [](fi_handle handle, long offset, int origin) {
                return stream_of(handle).seek(offset, origin) ? 0 : -1;
            },
            tell};
}

void PictureStream::rewind() {
    seek(0, SEEK_SET);
    gave_less_ = gave_nothing_ = false;
}

unsigned PictureStream::read(void *buffer, unsigned size, unsigned count) {
    const std::streamsize wanted = std::streamsize{size} * count;
    stream_.read(static_cast<char *>(buffer), wanted);
    const std::streamsize got = stream_.gcount();
    stream_.clear();
    // FreeImage looks at all of the buffer all the same when it guesses the format.
    std::fill_n(static_cast<char *>(buffer) + got, wanted - got, '\0');
    const std::streamsize units = size == 0 ? 0 : got / size;
    gave_less_ = gave_less_ || got < wanted;
    gave_nothing_ = gave_nothing_ || (units == 0 && wanted > 0);
    return static_cast<unsigned>(units);
}

bool PictureStream::seek(long offset, int origin) {
    const auto direction = origin == SEEK_SET   ? std::ios::beg
                           : origin == SEEK_CUR ? std::ios::cur
                                                : std::ios::end;
    const bool moved = bool(stream_.seekg(offset, direction));
    stream_.clear();
    return moved;
}

}  // namespace stagelight
