#include "formats/image_header.h"

#include "formats/sniff.h"
#include "formats/unique_fd.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <bit>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbake {

namespace {

/// Bytes of a file, read where they are asked for; zeros beyond its end, which no format takes for a size.
class Bytes {
  public:
    explicit Bytes(int fd) : fd_(fd) {}

    std::uint32_t at(std::uint64_t offset, int size, bool big_endian) const {
        unsigned char bytes[4] = {};
        if (offset > std::uint64_t(1) << 40 || ::pread(fd_, bytes, std::size_t(size), off_t(offset)) != size) return 0;
        std::uint32_t value = 0;
        for (int k = 0; k < size; ++k) value |= std::uint32_t(bytes[k]) << 8 * (big_endian ? size - 1 - k : k);
        return value;
    }
    std::uint32_t little(std::uint64_t offset, int size) const { return at(offset, size, false); }
    std::uint32_t big(std::uint64_t offset, int size) const { return at(offset, size, true); }

    std::string text(std::uint64_t offset, std::size_t size) const {
        std::string bytes(size, '\0');
        const ssize_t got = ::pread(fd_, bytes.data(), size, off_t(offset));
        bytes.resize(got > 0 ? std::size_t(got) : 0);
        return bytes;
    }

  private:
    int fd_;
};

/// PNG (ISO/IEC 15948), 11.2.2: IHDR is the first chunk.
ImageHeader png_header(const Bytes& file) {
    const std::uint32_t colour = file.big(25, 1);
    return {file.big(16, 4), file.big(20, 4), int(file.big(24, 1)), colour == 0 || colour == 3};
}

/// TIFF 6.0, section 2: the first directory of a classic file.
ImageHeader tiff_header(const Bytes& file) {
    const bool big = file.text(0, 2) == "MM";
    const std::uint64_t directory = file.at(4, 4, big);
    ImageHeader header{0, 0, 1, true};
    const std::uint32_t entries = file.at(directory, 2, big);
    for (std::uint32_t k = 0; k < entries; ++k) {
        const std::uint64_t entry = directory + 2 + 12ull * k;
        const std::uint32_t tag = file.at(entry, 2, big), type = file.at(entry + 2, 2, big), count = file.at(entry + 4, 4, big);
        const std::uint32_t value = type == 3 ? file.at(entry + 8, 2, big) : file.at(entry + 8, 4, big);
        if (tag == 256) header.width = value;
        if (tag == 257) header.height = value;
        if (tag == 258) header.bits = int((count <= 2 ? value : file.at(value, 2, big)) & 255);
        if (tag == 277) header.single = value == 1;
    }
    return header;
}

/// OpenEXR file layout: attributes "name\0type\0size value"; dataWindow is a box2i.
ImageHeader exr_header(const Bytes& file) {
    const std::string head = file.text(0, 1 << 16);
    constexpr std::string_view window("dataWindow\0box2i\0\x10\0\0\0", 21);
    const std::size_t found = head.find(window);
    if (found == head.npos) return {};
    const auto corner = [&](int k) { return std::int64_t(std::int32_t(file.little(found + window.size() + 4ull * std::uint64_t(k), 4))); };
    return {corner(2) - corner(0) + 1, corner(3) - corner(1) + 1, 32, false};
}

/// JPEG (ITU-T T.81), annex B: the frame header is one of SOF0 to SOF15 without DHT, JPG, DAC.
ImageHeader jpeg_header(const Bytes& file) {
    std::uint64_t at = 2;
    for (int segments = 0; segments < 1000 && file.big(at, 1) == 0xff; ++segments) {
        const std::uint32_t marker = file.big(at + 1, 1);
        const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (frame) return {file.big(at + 7, 2), file.big(at + 5, 2), int(file.big(at + 4, 1)), file.big(at + 9, 1) == 1};
        at += 2 + (marker == 0xff ? 0 : file.big(at + 2, 2));
    }
    return {};
}

/// "P5 # comment\n640 480 255", "Pf\n640 480\n-1.0".
ImageHeader pnm_header(const Bytes& file) {
    const std::string head = file.text(0, 1024);
    std::vector<std::string> words;
    for (std::size_t at = 0; at < head.size() && words.size() < 4;) {
        const std::size_t begin = head.find_first_not_of(" \t\r\n", at);
        if (begin == head.npos) break;
        at = head.find_first_of(head[begin] == '#' ? "\n" : " \t\r\n", begin);
        if (head[begin] != '#') words.push_back(head.substr(begin, at == head.npos ? at : at - begin));
        if (at == head.npos) break;
    }
    if (words.size() < 3) return {};
    const bool single = words[0] == "P5" || words[0] == "P2" || words[0] == "Pf";
    const long most = words.size() > 3 ? std::atol(words[3].c_str()) : 255;
    return {std::atol(words[1].c_str()), std::atol(words[2].c_str()), words[0][1] == 'f' || words[0][1] == 'F' ? 32 : most > 255 ? 16 : 8, single};
}

/// Radiance: a blank line, then "-Y height +X width".
ImageHeader hdr_header(const Bytes& file) {
    const std::string head = file.text(0, 1 << 14);
    const std::size_t line = head.find("\n\n");
    char y[3], x[3];
    long height = 0, width = 0;
    if (line == head.npos || std::sscanf(head.c_str() + line + 2, "%2s %ld %2s %ld", y, &height, x, &width) != 4) return {};
    return {width, height, 32, false};
}

ImageHeader header_of(ImageFormat format, const Bytes& file) {
    switch (format) {
    case ImageFormat::png: return png_header(file);
    case ImageFormat::tiff: return tiff_header(file);
    case ImageFormat::openexr: return exr_header(file);
    case ImageFormat::hdr: return hdr_header(file);
    case ImageFormat::jpeg: return jpeg_header(file);
    case ImageFormat::targa: return {file.little(12, 2), file.little(14, 2), 8, file.little(16, 1) == 8};
    case ImageFormat::bmp: return {file.little(18, 4), std::abs(std::int64_t(std::int32_t(file.little(22, 4)))), int(file.little(28, 2)) == 1 ? 1 : 8, false};
    case ImageFormat::pnm: return pnm_header(file);
    }
    return {};
}

} // namespace

std::optional<ImageHeader> peek_image_header(const std::filesystem::path& path) {
    // O_NONBLOCK: opening a FIFO must not wait for a writer.
    const UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (!fd || ::fstat(fd.get(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
    const Bytes file(fd.get());
    const std::string head = file.text(0, 18);
    const std::optional<ImageFormat> format = sniff_format(std::as_bytes(std::span(head)), path);
    if (!format) return {};
    const ImageHeader header = header_of(*format, file);
    constexpr std::int64_t most = 0x7fffffff;
    if (header.width < 1 || header.height < 1 || header.width > most || header.height > most) return {};
    return header;
}

} // namespace reliefbake
