#include "formats/record_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace reliefbake {

Result<RecordFile> RecordFile::open(const std::filesystem::path& path) {
    UniqueFd fd(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    if (!fd) return fail(ErrorCode::cannot_create, path.string() + ": cannot open: " + std::strerror(errno));
    if (::flock(fd.get(), LOCK_EX | LOCK_NB) != 0)
        return fail(ErrorCode::usage, path.string() + ": another run is writing it; wait for its end or choose another folder");
    RecordFile file(std::move(fd), path.string());
    if (Result<void> read = file.read_lines(); !read) return tl::unexpected(read.error());
    return file;
}

Result<void> RecordFile::read_lines() {
    std::string text;
    char block[1 << 16];
    for (ssize_t size; (size = ::pread(fd_.get(), block, sizeof block, off_t(text.size()))) != 0;) {
        if (size < 0) return fail(ErrorCode::cannot_create, name_ + ": cannot read: " + std::strerror(errno));
        text.append(block, std::size_t(size));
    }
    std::size_t begin = 0;
    for (std::size_t end; (end = text.find('\n', begin)) != text.npos; begin = end + 1) lines_.push_back(text.substr(begin, end - begin));
    if (begin < text.size() && ::ftruncate(fd_.get(), off_t(begin)) != 0)
        return fail(ErrorCode::write_failed, name_ + ": cannot take off a torn line: " + std::strerror(errno));
    return {};
}

Result<void> RecordFile::append(const std::string& line) {
    const std::string text = line + '\n';
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t size = ::write(fd_.get(), text.data() + at, text.size() - at);
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) return fail(ErrorCode::write_failed, name_ + ": cannot write: " + std::strerror(errno));
        at += std::size_t(size);
    }
    return {};
}

} // namespace reliefbake
