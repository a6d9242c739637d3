#include "formats/decode_session.h"

#include "formats/claims_json.h"
#include "formats/header_facts.h"
#include "formats/shared_memory.h"
#include "formats/tiff_facts.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

namespace reliefbake {

struct DecodeSession::InputFile {
    UniqueFd fd;
    std::uint64_t bytes;
};

namespace {

/// Libraries' scratch memory beside the pixels: line buffers, zlib, one EXR chunk.
constexpr std::uint64_t scratch_memory = 160ull << 20;

/// Processor time for decoding: a slow codec delivers 16 MiB of samples a second, and a second to get going.
int decode_seconds(std::uint64_t bytes) {
    constexpr std::uint64_t longest = 24 * 3600; // also keeps a boundless --max-bytes inside an int
    return int(std::min<std::uint64_t>(2 + bytes / (16ull << 20), longest));
}

Result<DecodeSession::InputFile> open_input(const std::filesystem::path& path) {
    // O_NONBLOCK: opening a FIFO must not wait for a writer.
    UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (!fd || ::fstat(fd.get(), &status) != 0)
        return fail(ErrorCode::no_input, path.string() + ": cannot open: " + std::generic_category().message(errno));
    if (!S_ISREG(status.st_mode)) return fail(ErrorCode::no_input, path.string() + ": is not a regular file");
    return DecodeSession::InputFile{std::move(fd), std::uint64_t(status.st_size)};
}

Result<ImageFormat> format_of(const DecodeSession::InputFile& file, const std::filesystem::path& path) {
    std::array<std::byte, 18> head;
    const ssize_t size = ::pread(file.fd.get(), head.data(), head.size(), 0);
    if (size < 0) return fail(ErrorCode::no_input, path.string() + ": cannot read: " + std::generic_category().message(errno));
    if (size == 0) return fail(ErrorCode::bad_data, path.string() + ": is empty");
    const std::string_view start(reinterpret_cast<const char*>(head.data()), std::size_t(size));
    if (start.starts_with("DDS ") || start.starts_with("\xabKTX 20\xbb"))
        return fail(ErrorCode::bad_data, path.string() + ": DDS and KTX2 are written, not read; read the same as one of " +
                                             std::string(accepted_formats));
    if (const auto format = sniff_format(std::span(head).first(std::size_t(size)), path)) return *format;
    return fail(ErrorCode::bad_data, path.string() + ": is none of " + std::string(accepted_formats));
}

} // namespace

Result<DecodeSession> DecodeSession::open(const std::filesystem::path& path, std::uint64_t max_bytes, int planes, int level) {
    const Result<InputFile> file = open_input(path);
    if (!file) return tl::unexpected(file.error());
    const Result<ImageFormat> format = format_of(*file, path);
    if (!format) return tl::unexpected(format.error());

    if (level > 0 && *format != ImageFormat::openexr && *format != ImageFormat::tiff)
        return fail(ErrorCode::usage, path.string() + ": only EXR and TIFF files hold mip levels; a numbered file holds one alone");

    DecodeSession session(path, *file, *format);
    session.level_ = level;
    session.max_bytes_ = max_bytes;
    const std::uint64_t allowed = decode_budget(file->bytes, max_bytes);
    // Twice: a progressive JPEG keeps 16-bit coefficients, an interlaced PNG its rows, and the reader's copy.
    constexpr std::uint64_t boundless = 1ull << 60;
    session.memory_ = scratch_memory + 2 * std::min(allowed, boundless);
    return session.begin(*file, decode_seconds(*format == ImageFormat::jpeg ? allowed : 0), planes).map([&] { return std::move(session); });
}

Result<DecodeSession> DecodeSession::open_rows(const std::filesystem::path& path, std::uint64_t max_bytes) {
    const Result<InputFile> file = open_input(path);
    if (!file) return tl::unexpected(file.error());
    const Result<ImageFormat> format = format_of(*file, path);
    if (!format) return tl::unexpected(format.error());
    if (*format != ImageFormat::openexr && *format != ImageFormat::tiff)
        return fail(ErrorCode::usage, path.string() + ": only EXR and TIFF files are read row by row");

    DecodeSession session(path, *file, *format);
    constexpr std::uint64_t least = 64ull << 20, rate = 1000;
    session.max_bytes_ = max_bytes > 0 ? max_bytes : std::max(least, rate * file->bytes);
    session.memory_ = scratch_memory;
    if (Result<void> begun = session.begin(*file, decode_seconds(0), 0); !begun) return tl::unexpected(begun.error());
    // A row of tiles: as stored, as the library converts it, and the block of floats.
    ImageClaims row = session.claims_;
    row.height = std::max<std::int64_t>(row.tile_height, 64);
    session.memory_ = scratch_memory + 4 * decoded_bytes(row);
    return session;
}

DecodeSession::DecodeSession(const std::filesystem::path& path, const InputFile& file, ImageFormat format)
    : name_(path.string()), file_bytes_(file.bytes), format_(format) {}

Result<void> DecodeSession::begin(const InputFile& file, int seconds, int planes) {
    ImageWorker& worker = ImageWorker::instance();
    lock_ = worker.lock();
    const Result<Message> answer = worker.ask({{"do", "open"}, {"reader", reader_name(format_)}, {"level", level_}}, file.fd.get(),
                                              {seconds, memory_}, ImageWorker::Turn::first, ErrorCode::bad_data, name_);
    if (!answer) return tl::unexpected(answer.error());
    auto claims = claims_from_json(answer->body);
    if (!claims) return fail(ErrorCode::bad_data, name_ + ": the image helper's answer makes no sense");
    claims_ = std::move(*claims);
    return check_planes(planes).and_then([&] { return look_closer(file); });
}

Result<void> DecodeSession::check_planes(int planes) const {
    return check_claims(claims_, file_bytes_, max_bytes_, planes, name_);
}

Result<void> DecodeSession::look_closer(const InputFile& file) {
    const auto truncated = [&] { return fail(ErrorCode::bad_data, name_ + ": is truncated: pixels lie past its end"); };
    if (format_ == ImageFormat::png && png_has_srgb_chunk(file.fd.get())) claims_.srgb_tagged = true;
    if (format_ == ImageFormat::jpeg && !jpeg_has_end(file.fd.get(), file.bytes)) return truncated();
    if (format_ == ImageFormat::tiff) {
        const TiffFacts facts = read_tiff_facts(file.fd.get(), file.bytes, level_);
        if (!facts.pixels_in_file) return truncated();
        no_data_ = facts.no_data;
    }
    return {};
}

Result<void> DecodeSession::read(std::span<const int> channels, const TakeRows& take) {
    ImageWorker& worker = ImageWorker::instance();
    const ImageWorker::Limits limits{decode_seconds(decoded_bytes(claims_)), memory_};
    const auto ask = [&](nlohmann::json request) {
        return worker.ask(std::move(request), -1, limits, ImageWorker::Turn::later, ErrorCode::bad_data, name_);
    };
    const auto nonsense = [&] { return fail(ErrorCode::bad_data, name_ + ": the image helper's answer makes no sense"); };

    // Agree on the block.
    Result<Message> answer = ask({{"do", "read"}, {"channels", std::vector<int>(channels.begin(), channels.end())}});
    if (!answer) return tl::unexpected(answer.error());
    const std::uint64_t row_bytes = std::uint64_t(claims_.width) * channels.size() * sizeof(float);
    const auto block = SharedMemory::adopt(std::move(answer->fd), unsigned_member(answer->body, "bytes"));
    if (!block) return nonsense();

    // Take block after block.
    for (std::int64_t y = 0; y < claims_.height;) {
        answer = ask({{"do", "next"}});
        if (!answer) return tl::unexpected(answer.error());
        const std::uint64_t rows = unsigned_member(answer->body, "rows");
        if (rows < 1 || rows > std::uint64_t(claims_.height - y) || rows * row_bytes > block->bytes().size()) return nonsense();
        take(int(y), int(rows), reinterpret_cast<const float*>(block->bytes().data()));
        y += std::int64_t(rows);
    }
    return {};
}

} // namespace reliefbake
