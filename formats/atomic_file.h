#pragma once
// A file at a final name is complete, or the previous one, or absent (docs/FORMATS.md).

#include "bake/error.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace reliefbake {

/// Temporary in the same directory (O_EXCL), checked write, fsync, rename, fsync of the directory. On any error the
/// temporary is gone and `path` is untouched. A symbolic link stays; the file it names is replaced. Thread-safe.
/// Errors: cannot_create (no such directory, no permission, not a regular file), write_failed (disk full, ...).
/// Only SIGKILL and a power cut leave a temporary behind: .reliefbake-PID-N.tmp, safe to delete.
Result<void> write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
inline Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view text) { return write_file_atomically(path, std::as_bytes(std::span(text))); }

/// Files that appear together: each lies complete in a temporary beside its final name until all are published. Without that,
/// nothing has changed and the temporaries are gone.
class FileBatch {
  public:
    FileBatch();
    ~FileBatch();
    FileBatch(const FileBatch&) = delete;
    FileBatch& operator=(const FileBatch&) = delete;

    /// Errors as write_file_atomically; write_failed, too, for more files than can be kept track of (1024 a process).
    Result<void> add(const std::filesystem::path& path, std::span<const std::byte> bytes);

    /// Creates the temporary alone, for a file that is written piece by piece; its descriptor stays this batch's, write only. Whoever
    /// writes believes nothing before `publish` has asked the disk. Errors as `add`.
    Result<int> open(const std::filesystem::path& path);

    /// Renames all, one right after the other, in the order of `add`. Each file is whole at any time; the one step that can still
    /// fail is a rename (write_failed), and files before it stay.
    Result<void> publish();

  private:
    struct Staged;
    std::vector<std::unique_ptr<Staged>> files_;
};

/// From now on a file that already holds the very bytes is not written again and keeps its time (--if-changed), or is, as at first. For the
/// whole process, before its work.
void leave_equal_files(bool leave);

/// Removes temporaries in `folder` and below it that a run which was killed left behind, and returns them; one whose writer still
/// runs on this machine stays.
std::vector<std::filesystem::path> remove_abandoned_temporaries(const std::filesystem::path& folder);

/// Removes temporaries of writes in progress, which then fail, as all later ones do; async-signal-safe. The last call of a SIGINT or SIGTERM
/// handler before _exit.
void remove_temporaries_on_signal() noexcept;

} // namespace reliefbake
