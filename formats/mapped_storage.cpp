#include "formats/mapped_storage.h"

#include "formats/scratch_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <new>

namespace reliefbake {

namespace {

constexpr auto watch_period = std::chrono::milliseconds(4);

std::size_t rounded(std::size_t bytes) { return (bytes + MappedStorage::array_step - 1) / MappedStorage::array_step * MappedStorage::array_step; }

/// Bytes of resident pages that belong to files or shared memory (proc(5), statm). `fd` is open on it.
std::uint64_t resident_file_bytes(int fd) {
    char text[128];
    const ssize_t size = ::pread(fd, text, sizeof text - 1, 0);
    if (size <= 0) return 0;
    text[size] = 0;
    unsigned long whole = 0, resident = 0, shared = 0;
    if (std::sscanf(text, "%lu %lu %lu", &whole, &resident, &shared) != 3) return 0;
    static const std::uint64_t page = std::uint64_t(::sysconf(_SC_PAGESIZE));
    return shared * page;
}

} // namespace

Result<std::unique_ptr<MappedStorage>> MappedStorage::create(const std::filesystem::path& directory, std::uint64_t capacity, std::uint64_t resident) {
    Result<UniqueFd> fd = reserve_scratch(directory, capacity);
    if (!fd) return tl::unexpected(fd.error());
    return std::unique_ptr<MappedStorage>(new MappedStorage(std::move(*fd), capacity, resident));
}

MappedStorage::MappedStorage(UniqueFd fd, std::uint64_t capacity, std::uint64_t resident)
    : fd_(std::move(fd)), capacity_(capacity), resident_(resident), watch_(&MappedStorage::keep_watch, this) {}

MappedStorage::~MappedStorage() {
    {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
    }
    changed_.notify_one();
    watch_.join();
}

void* MappedStorage::do_allocate(std::size_t bytes, std::size_t) {
    const std::lock_guard lock(mutex_);
    const std::size_t size = rounded(bytes);
    if (size > capacity_ - used_) throw std::bad_alloc();
    void* memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, fd_.get(), off_t(used_));
    if (memory == MAP_FAILED) throw std::bad_alloc();
    used_ += size;
    arrays_.emplace(memory, size);
    return memory;
}

void MappedStorage::do_deallocate(void* memory, std::size_t, std::size_t) {
    const std::lock_guard lock(mutex_);
    const auto array = arrays_.find(memory);
    ::munmap(memory, array->second);
    arrays_.erase(array);
}

void MappedStorage::keep_watch() {
    const UniqueFd statm(::open("/proc/self/statm", O_RDONLY | O_CLOEXEC));
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, watch_period, [this] { return stopped_; }))
        if (resident_file_bytes(statm.get()) > resident_) let_go();
}

/// MADV_DONTNEED on a shared mapping: the pages leave this process; the file keeps what was written to them.
void MappedStorage::let_go() {
    for (const auto& [memory, size] : arrays_) ::madvise(memory, size, MADV_DONTNEED);
}

} // namespace reliefbake
