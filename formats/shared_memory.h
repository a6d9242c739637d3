#pragma once
// Memory that travels between the tool and its helper process as a file descriptor.

#include "formats/unique_fd.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace reliefbake {

/// A mapped memfd. Its size is sealed: neither side can shrink it under the other's feet (that would be a SIGBUS).
class SharedMemory {
  public:
    /// Zero-filled; empty when the system refuses (no memory, RLIMIT_FSIZE, RLIMIT_AS).
    static std::optional<SharedMemory> create(std::uint64_t size);
    /// Maps memory received from the other side; empty unless it is sealed and holds exactly `size` bytes.
    static std::optional<SharedMemory> adopt(UniqueFd fd, std::uint64_t size);

    SharedMemory(SharedMemory&& other) noexcept;
    SharedMemory& operator=(SharedMemory&& other) noexcept;
    ~SharedMemory();

    int fd() const { return fd_.get(); }
    std::span<std::byte> bytes() const { return {data_, size_}; }

  private:
    SharedMemory(UniqueFd fd, std::byte* data, std::size_t size) : fd_(std::move(fd)), data_(data), size_(size) {}
    static std::optional<SharedMemory> map(UniqueFd fd, std::uint64_t size);

    UniqueFd fd_;
    std::byte* data_ = nullptr;
    std::size_t size_ = 0;
};

} // namespace reliefbake
