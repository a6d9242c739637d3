#include "formats/whole_file.h"

#include "formats/unique_fd.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

namespace reliefbake {

Result<std::string> read_whole_file(const std::filesystem::path& path, std::uint64_t most) {
    const auto failed = [&](const char* what) {
        return fail(ErrorCode::no_input, path.string() + ": " + what + ": " + std::generic_category().message(errno));
    };
    // O_NONBLOCK: opening a FIFO must not wait for a writer.
    const UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (!fd || ::fstat(fd.get(), &status) != 0) return failed("cannot open");
    if (!S_ISREG(status.st_mode)) return fail(ErrorCode::no_input, path.string() + ": is not a regular file");
    if (std::uint64_t(status.st_size) > most)
        return fail(ErrorCode::bad_data, path.string() + ": has " + std::to_string(status.st_size) + " bytes, more than the budget of " +
                                             std::to_string(most) + "; --max-bytes lifts it");
    std::string bytes(std::size_t(status.st_size), '\0');
    std::size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t got = ::read(fd.get(), bytes.data() + have, bytes.size() - have);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return failed("cannot read");
        if (got == 0) break;
        have += std::size_t(got);
    }
    bytes.resize(have);
    return bytes;
}

} // namespace reliefbake
