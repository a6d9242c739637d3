#pragma once
// Arrays that lie on a disk and are addressed as memory.

#include "bake/error.h"
#include "formats/unique_fd.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <memory_resource>
#include <mutex>
#include <condition_variable>
#include <thread>

namespace reliefbake {

/// Storage for large arrays in a nameless file, of which a bounded part is resident: a thread of its own looks every few
/// milliseconds and lets the pages go when they are too many. Their content stays in the file (and in the system's page cache as far
/// as there is room), so letting go costs time, never data.
class MappedStorage : public std::pmr::memory_resource {
  public:
    /// `capacity`: bytes of all arrays ever made, each rounded up to array_step; the disk promises them here (else write_failed).
    /// `resident`: bytes of files' pages that this process may keep; overshot by what its threads touch in a few milliseconds.
    static Result<std::unique_ptr<MappedStorage>> create(const std::filesystem::path& directory, std::uint64_t capacity, std::uint64_t resident);
    ~MappedStorage() override;

    static constexpr std::uint64_t array_step = 1u << 16;

  private:
    MappedStorage(UniqueFd fd, std::uint64_t capacity, std::uint64_t resident);
    /// Throws std::bad_alloc beyond the capacity.
    void* do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override;
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
    void keep_watch();
    void let_go();

    UniqueFd fd_;
    const std::uint64_t capacity_, resident_;
    std::uint64_t used_ = 0;
    std::mutex mutex_;
    std::map<void*, std::size_t> arrays_;
    std::condition_variable changed_;
    bool stopped_ = false;
    std::thread watch_;
};

} // namespace reliefbake
