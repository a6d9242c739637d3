#include "formats/scratch_file.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

namespace reliefbake {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_call = 1u << 30;

tl::unexpected<Error> no_space(const fs::path& directory, const std::string& what, int error) {
    const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
    return fail(full ? ErrorCode::write_failed : ErrorCode::cannot_create,
                directory.string() + ": " + what + ": " + std::generic_category().message(error));
}

/// For file systems without O_TMPFILE.
UniqueFd open_and_unlink(const fs::path& directory) {
    std::string name = (directory / ".reliefbake-scratch-XXXXXX").string();
    UniqueFd fd(::mkostemp(name.data(), O_CLOEXEC));
    if (fd) ::unlink(name.c_str());
    return fd;
}

} // namespace

Result<UniqueFd> open_scratch(const fs::path& directory) {
    const fs::path where = directory.empty() ? fs::path(".") : directory;
    UniqueFd fd(::open(where.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
    if (!fd && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL)) fd = open_and_unlink(where);
    if (!fd) return no_space(where, "cannot create working space here", errno);
    return fd;
}

Result<UniqueFd> reserve_scratch(const fs::path& directory, std::uint64_t bytes) {
    Result<UniqueFd> fd = open_scratch(directory);
    if (!fd) return fd;
    int error = 0;
    do error = ::posix_fallocate(fd->get(), 0, off_t(bytes));
    while (error == EINTR);
    if (error) return no_space(directory.empty() ? "." : directory, std::to_string(bytes >> 20) + " MiB of working space are not to be had here", error);
    return fd;
}

bool write_at(int fd, std::uint64_t offset, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t done = ::pwrite(fd, bytes.data(), std::min(bytes.size(), longest_call), off_t(offset));
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) return false;
        bytes = bytes.subspan(std::size_t(done)), offset += std::uint64_t(done);
    }
    return true;
}

bool read_at(int fd, std::uint64_t offset, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t done = ::pread(fd, bytes.data(), std::min(bytes.size(), longest_call), off_t(offset));
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) {
            if (done == 0) errno = 0;
            return false;
        }
        bytes = bytes.subspan(std::size_t(done)), offset += std::uint64_t(done);
    }
    return true;
}

} // namespace reliefbake
