#include "formats/atomic_file.h"

#include "formats/unique_fd.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <semaphore>
#include <string>
#include <system_error>

namespace reliefbake {

namespace fs = std::filesystem;

namespace {

// Names of temporaries that exist, where a signal handler can read them: no locks, no allocation.
constexpr int max_writers = 1024;
struct Slot {
    std::atomic<bool> taken{false};
    std::atomic<bool> armed{false};
    char path[PATH_MAX] = {};
};
Slot slots[max_writers];
std::counting_semaphore<max_writers> free_slots(max_writers);
static_assert(std::atomic<bool>::is_always_lock_free);

// Once `closing` is set no temporary stays that is made then; `creating` counts those between their look at it and their file.
std::atomic<bool> closing{false};
std::atomic<int> creating{0};
static_assert(std::atomic<int>::is_always_lock_free);

/// Keeps one temporary's name known to remove_temporaries_on_signal, and removes the file unless it was renamed.
class Temporary {
  public:
    /// There must be a free slot: free_slots was acquired.
    Temporary() {
        for (Slot& slot : slots)
            if (!slot.taken.exchange(true)) {
                slot_ = &slot;
                return;
            }
    }
    ~Temporary() {
        if (slot_->armed.exchange(false)) ::unlink(slot_->path);
        slot_->taken = false;
        free_slots.release();
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    const char* path() const { return slot_->path; }
    void release() { slot_->armed = false; }

    /// Creates `directory`/.reliefbake-PID-N.tmp; the name is registered first, so that a signal finds it.
    UniqueFd create(const fs::path& directory) {
        static std::atomic<unsigned> counter{0};
        for (int attempt = 0; attempt < 100; ++attempt) {
            const std::string name = ".reliefbake-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp";
            const std::string path = (directory / name).string();
            if (path.size() >= sizeof slot_->path) {
                errno = ENAMETOOLONG;
                return UniqueFd();
            }
            std::memcpy(slot_->path, path.c_str(), path.size() + 1);
            slot_->armed = true;
            ++creating;
            UniqueFd fd(closing ? -1 : ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
            --creating;
            if (fd) return fd;
            if (closing) errno = EINTR;
            slot_->armed = false;
            if (errno != EEXIST) break;
        }
        return UniqueFd();
    }

  private:
    Slot* slot_ = nullptr;
};

tl::unexpected<Error> system_error(ErrorCode code, const fs::path& path, const char* action, int error) {
    return fail(code, path.string() + ": " + action + ": " + std::generic_category().message(error));
}

bool write_all(int fd, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd, bytes.data(), std::min<std::size_t>(bytes.size(), 1u << 30));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes = bytes.subspan(std::size_t(written));
    }
    return true;
}

/// A rename is durable once its directory is on the disk. Some file systems cannot sync directories: EINVAL.
bool sync_directory(const fs::path& directory) {
    UniqueFd fd(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!fd) return errno == EACCES; // writable but not readable: nothing more can be done
    return ::fsync(fd.get()) == 0 || errno == EINVAL;
}

/// The file behind a symbolic link, so that the link survives; refuses what rename would destroy.
Result<fs::path> target_of(const fs::path& path) {
    std::error_code error;
    fs::path target = path;
    for (int links = 0; fs::is_symlink(target, error); ++links) {
        constexpr int most_links = 40; // Linux follows as many
        if (links == most_links) return system_error(ErrorCode::cannot_create, path, "cannot create", ELOOP);
        target = target.parent_path() / fs::read_symlink(target, error);
    }
    const fs::file_status status = fs::status(target, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        return fail(ErrorCode::cannot_create, path.string() + ": cannot create: there is something here that is not a file");
    return target;
}

std::atomic<bool> equal_files_stay{false};

bool read_block(int fd, std::vector<std::byte>& block) {
    std::size_t filled = 0;
    while (filled < block.size()) {
        const ssize_t read = ::read(fd, block.data() + filled, block.size() - filled);
        if (read < 0 && errno == EINTR) continue;
        if (read < 0) return false;
        if (read == 0) break;
        filled += std::size_t(read);
    }
    block.resize(filled);
    return true;
}

bool have_equal_bytes(const char* a, const char* b) {
    const UniqueFd fd_a(::open(a, O_RDONLY | O_CLOEXEC)), fd_b(::open(b, O_RDONLY | O_CLOEXEC));
    if (!fd_a || !fd_b) return false;
    constexpr std::size_t size = 1u << 20;
    std::vector<std::byte> block_a(size), block_b(size);
    while (block_a.size() == size)
        if (!read_block(fd_a.get(), block_a) || !read_block(fd_b.get(), block_b) || block_a != block_b) return false;
    return true;
}

/// Whether a process of this number runs, and is this tool: numbers are used again.
bool is_running_tool(int pid) {
    std::ifstream comm("/proc/" + std::to_string(pid) + "/comm");
    std::string name;
    return std::getline(comm, name) && name.starts_with("reliefbake");
}

} // namespace

struct FileBatch::Staged {
    fs::path path, target, directory;
    Temporary temporary;

    UniqueFd fd{};

    /// Creates the temporary beside its final name: rename works within one file system only.
    Result<void> create() {
        fd = temporary.create(directory);
        if (fd) return {};
        const bool full = errno == ENOSPC || errno == EDQUOT;
        return system_error(full ? ErrorCode::write_failed : ErrorCode::cannot_create, path, "cannot create", errno);
    }

    Result<void> stopped() const {
        return system_error(ErrorCode::write_failed, path, "writing stopped half-way, nothing was left behind", errno);
    }

    Result<void> write(std::span<const std::byte> bytes) {
        return write_all(fd.get(), bytes) ? sync() : stopped();
    }

    /// Believes nothing before the disk says so.
    Result<void> sync() {
        if (!fd) return {};
        if (::fsync(fd.get()) != 0 || !fd.reset()) return stopped();
        return {};
    }

    Result<void> publish() {
        if (equal_files_stay && have_equal_bytes(temporary.path(), target.c_str())) return {}; // the temporary goes with this
        if (::rename(temporary.path(), target.c_str()) != 0)
            return system_error(ErrorCode::write_failed, path, "cannot rename the finished temporary", errno);
        temporary.release();
        if (!sync_directory(directory))
            return system_error(ErrorCode::write_failed, path, "written, but its directory cannot be synchronised", errno);
        return {};
    }
};

FileBatch::FileBatch() = default;
FileBatch::~FileBatch() = default;

Result<int> FileBatch::open(const fs::path& path) {
    const Result<fs::path> target = target_of(path);
    if (!target) return tl::unexpected(target.error());
    // A batch that waited for slots of its own would wait for ever.
    if (files_.empty()) free_slots.acquire();
    else if (!free_slots.try_acquire()) return fail(ErrorCode::write_failed, path.string() + ": too many files at once");
    const fs::path directory = target->has_parent_path() ? target->parent_path() : fs::path(".");
    files_.push_back(std::unique_ptr<Staged>(new Staged{path, *target, directory, {}}));
    if (const Result<void> created = files_.back()->create(); !created) {
        files_.pop_back(); // never to be published
        return tl::unexpected(created.error());
    }
    return files_.back()->fd.get();
}

Result<void> FileBatch::add(const fs::path& path, std::span<const std::byte> bytes) {
    if (const Result<int> opened = open(path); !opened) return tl::unexpected(opened.error());
    const Result<void> written = files_.back()->write(bytes);
    if (!written) files_.pop_back();
    return written;
}

Result<void> FileBatch::publish() {
    for (const std::unique_ptr<Staged>& file : files_)
        if (Result<void> synced = file->sync(); !synced) return synced;
    for (const std::unique_ptr<Staged>& file : files_)
        if (Result<void> published = file->publish(); !published) return published;
    files_.clear();
    return {};
}

Result<void> write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
    FileBatch batch;
    return batch.add(path, bytes).and_then([&] { return batch.publish(); });
}

void leave_equal_files(bool leave) { equal_files_stay = leave; }

std::vector<fs::path> remove_abandoned_temporaries(const fs::path& folder) {
    std::vector<fs::path> removed;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        int pid = 0, end_of_name = 0;
        if (std::sscanf(name.c_str(), ".reliefbake-%d-%*u.tmp%n", &pid, &end_of_name) != 1 || std::size_t(end_of_name) != name.size()) continue;
        if (is_running_tool(pid)) continue;
        std::error_code ignored;
        if (fs::remove(entry->path(), ignored)) removed.push_back(entry->path());
    }
    return removed;
}

void remove_temporaries_on_signal() noexcept {
    const int saved_errno = errno;
    closing = true;
    // Other threads end their open(); one that this handler interrupted never will, so wait for a moment only.
    constexpr timespec pause{0, 1000000};
    for (int wait = 0; creating > 0 && wait < 100; ++wait) ::nanosleep(&pause, nullptr);
    for (Slot& slot : slots)
        if (slot.armed) ::unlink(slot.path);
    errno = saved_errno;
}

} // namespace reliefbake
