#include "formats/journal.h"

#include "formats/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

namespace reliefbake {

namespace {

std::string reason() { return std::generic_category().message(errno); }

/// All bytes of an open file. False: errno says why.
bool read_all(int fd, std::string& text) {
    char block[1 << 16];
    for (ssize_t size; (size = ::pread(fd, block, sizeof block, off_t(text.size()))) != 0;) {
        if (size < 0 && errno == EINTR) continue;
        if (size < 0) return false;
        text.append(block, std::size_t(size));
    }
    return true;
}

/// The lines that have their end; returns where the last of them ends.
std::size_t split(const std::string& text, std::vector<std::string>& lines) {
    std::size_t begin = 0;
    for (std::size_t end; (end = text.find('\n', begin)) != text.npos; begin = end + 1) lines.push_back(text.substr(begin, end - begin));
    return begin;
}

bool write_all(int fd, const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t size = ::write(fd, text.data() + at, text.size() - at);
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) return false;
        at += std::size_t(size);
    }
    return true;
}

} // namespace

Result<std::optional<FolderLock>> FolderLock::take(const std::filesystem::path& file, Hold hold) {
    UniqueFd fd(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (!fd) return fail(ErrorCode::cannot_create, file.string() + ": cannot create: " + reason());
    if (::flock(fd.get(), (hold == Hold::alone ? LOCK_EX : LOCK_SH) | LOCK_NB) == 0) return FolderLock(std::move(fd));
    if (errno == EWOULDBLOCK) return std::nullopt;
    return fail(ErrorCode::cannot_create, file.string() + ": cannot lock: " + reason());
}

Result<Journal> Journal::open(const std::filesystem::path& path) {
    UniqueFd fd(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    if (!fd) return fail(ErrorCode::cannot_create, path.string() + ": cannot open: " + reason());
    Journal journal(std::move(fd), path);
    std::string text;
    if (!read_all(journal.fd_.get(), text)) return fail(ErrorCode::cannot_create, path.string() + ": cannot read: " + reason());
    const std::size_t whole = split(text, journal.lines_);
    if (whole < text.size() && ::ftruncate(journal.fd_.get(), off_t(whole)) != 0) return journal.failed("cannot cut off a torn line");
    return journal;
}

Result<std::vector<std::string>> Journal::read(const std::filesystem::path& path) {
    std::vector<std::string> lines;
    const UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!fd && errno == ENOENT) return lines;
    std::string text;
    if (!fd || !read_all(fd.get(), text)) return fail(ErrorCode::no_input, path.string() + ": cannot read: " + reason());
    split(text, lines);
    return lines;
}

tl::unexpected<Error> Journal::failed(const char* action) const {
    return fail(ErrorCode::write_failed, path_.string() + ": " + action + ": " + reason());
}

Result<void> Journal::append(const std::string& line) {
    struct stat before {};
    if (::fstat(fd_.get(), &before) != 0) return failed("cannot look at it");
    if (write_all(fd_.get(), line + '\n') && ::fsync(fd_.get()) == 0) return {};
    const tl::unexpected<Error> error = failed("cannot write");
    (void)!::ftruncate(fd_.get(), before.st_size); // the next line must not continue this one
    return error;
}

Result<void> Journal::replace(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    if (Result<void> written = write_file_atomically(path_, text); !written) return written;
    UniqueFd fd(::open(path_.c_str(), O_RDWR | O_APPEND | O_CLOEXEC));
    if (!fd) return fail(ErrorCode::cannot_create, path_.string() + ": cannot open: " + reason());
    fd_ = std::move(fd);
    lines_ = lines;
    return {};
}

} // namespace reliefbake
