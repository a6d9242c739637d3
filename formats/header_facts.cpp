#include "formats/header_facts.h"

#include <algorithm>
#include <cstring>
#include <string>

#include <unistd.h>

namespace reliefbake {

bool png_has_srgb_chunk(int fd) {
    // A chunk: length (big-endian), type, `length` bytes, CRC. Files have a dozen; the limit stops endless ones.
    constexpr int chunks_looked_at = 256;
    std::int64_t at = 8;
    for (int i = 0; i < chunks_looked_at; ++i) {
        unsigned char head[8];
        if (::pread(fd, head, sizeof head, at) != sizeof head) return false;
        if (std::memcmp(head + 4, "sRGB", 4) == 0) return true;
        if (std::memcmp(head + 4, "IDAT", 4) == 0) return false;
        const std::uint32_t length = std::uint32_t(head[0]) << 24 | head[1] << 16 | head[2] << 8 | head[3];
        at += 12 + std::int64_t(length);
    }
    return false;
}

bool jpeg_has_end(int fd, std::uint64_t file_bytes) {
    std::string tail(std::min<std::uint64_t>(file_bytes, 64 * 1024), '\0');
    const ssize_t size = ::pread(fd, tail.data(), tail.size(), off_t(file_bytes - tail.size()));
    // Neither marker can occur in compressed data; an end before the last scan's start is a thumbnail's.
    const std::size_t end = tail.rfind("\xff\xd9"), last_scan = tail.rfind("\xff\xda");
    return size == ssize_t(tail.size()) && end != tail.npos && (last_scan == tail.npos || last_scan < end);
}

} // namespace reliefbake
