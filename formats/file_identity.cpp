#include "formats/file_identity.h"

#include "formats/decode_session.h"
#include "formats/unique_fd.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <xxhash.h>

#include <bit>
#include <cerrno>
#include <memory>
#include <numeric>
#include <system_error>
#include <vector>

namespace reliefbake {

namespace {

class Hasher {
  public:
    Hasher() : state_(XXH3_createState(), XXH3_freeState) { XXH3_128bits_reset(state_.get()); }

    void add(const void* bytes, std::size_t size) { XXH3_128bits_update(state_.get(), bytes, size); }
    void add(const std::string& text) { add(text.c_str(), text.size() + 1); }

    std::string hex() const {
        XXH128_canonical_t canonical;
        XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state_.get()));
        std::string digits;
        for (const unsigned char byte : canonical.digest)
            for (const int nibble : {byte >> 4, byte & 15}) digits += "0123456789abcdef"[nibble];
        return digits;
    }

  private:
    std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

std::int64_t nanoseconds(const timespec& time) { return std::int64_t(time.tv_sec) * 1000000000 + time.tv_nsec; }

} // namespace

std::optional<FileStamp> stamp_of(const std::filesystem::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
    return FileStamp{std::uint64_t(status.st_size), std::uint64_t(status.st_ino), nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
}

Result<std::string> hash_of_bytes(const std::filesystem::path& path) {
    const auto failed = [&](const char* action) {
        return fail(ErrorCode::no_input, path.string() + ": " + action + ": " + std::generic_category().message(errno));
    };
    // O_NONBLOCK: opening a FIFO must not wait for a writer.
    const UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (!fd || ::fstat(fd.get(), &status) != 0) return failed("cannot open");
    if (!S_ISREG(status.st_mode)) return fail(ErrorCode::no_input, path.string() + ": is not a regular file");
    Hasher hash;
    std::vector<char> block(1 << 20);
    for (ssize_t size; (size = ::read(fd.get(), block.data(), block.size())) != 0;) {
        if (size < 0 && errno == EINTR) continue;
        if (size < 0) return failed("cannot read");
        hash.add(block.data(), std::size_t(size));
    }
    return hash.hex();
}

std::string hash_of_text(const std::string& text) {
    Hasher hash;
    hash.add(text.data(), text.size());
    return hash.hex();
}

Result<std::string> hash_of_image(const std::filesystem::path& path, std::uint64_t max_bytes) {
    static_assert(std::endian::native == std::endian::little, "the hash is defined on little-endian bytes");
    Result<DecodeSession> session = DecodeSession::open(path, max_bytes, 0);
    if (!session) return tl::unexpected(session.error());
    const ImageClaims& claims = session->claims();
    Hasher hash;
    hash.add("image " + std::to_string(claims.width) + " " + std::to_string(claims.height) + " " + std::to_string(int(claims.sample)) + " " +
             std::to_string(claims.bit_depth) + " " + std::to_string(claims.srgb_tagged) + " " + std::string(reader_name(session->format())));
    for (const std::string& channel : claims.channels) hash.add(channel);
    const std::optional<float> no_data = session->no_data();
    if (no_data) hash.add(&*no_data, sizeof *no_data);
    std::vector<int> channels(claims.channels.size());
    std::iota(channels.begin(), channels.end(), 0);
    const std::size_t row = std::size_t(claims.width) * channels.size() * sizeof(float);
    const Result<void> read = session->read(channels, [&](int, int rows, const float* samples) { hash.add(samples, std::size_t(rows) * row); });
    if (!read) return tl::unexpected(read.error());
    return hash.hex();
}

} // namespace reliefbake
