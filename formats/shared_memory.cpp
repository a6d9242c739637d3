#include "formats/shared_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <limits>

namespace reliefbake {

namespace {
constexpr int size_seals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;
}

std::optional<SharedMemory> SharedMemory::create(std::uint64_t size) {
    UniqueFd fd(::memfd_create("reliefbake", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!fd || size > std::uint64_t(std::numeric_limits<off_t>::max())) return std::nullopt;
    if (::ftruncate(fd.get(), off_t(size)) != 0 || ::fcntl(fd.get(), F_ADD_SEALS, size_seals) != 0) return std::nullopt;
    return map(std::move(fd), size);
}

std::optional<SharedMemory> SharedMemory::adopt(UniqueFd fd, std::uint64_t size) {
    struct stat status {};
    if (!fd || ::fstat(fd.get(), &status) != 0 || std::uint64_t(status.st_size) != size) return std::nullopt;
    const int seals = ::fcntl(fd.get(), F_GET_SEALS);
    if (seals < 0 || (seals & size_seals) != size_seals) return std::nullopt;
    return map(std::move(fd), size);
}

std::optional<SharedMemory> SharedMemory::map(UniqueFd fd, std::uint64_t size) {
    if (size == 0) return std::nullopt;
    void* data = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, fd.get(), 0);
    if (data == MAP_FAILED) return std::nullopt;
    return SharedMemory(std::move(fd), static_cast<std::byte*>(data), size);
}

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
    : fd_(std::move(other.fd_)), data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}

SharedMemory& SharedMemory::operator=(SharedMemory&& other) noexcept {
    std::swap(fd_, other.fd_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
}

SharedMemory::~SharedMemory() {
    if (data_) ::munmap(data_, size_);
}

} // namespace reliefbake
