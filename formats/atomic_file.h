#pragma once
// A file at a final name is complete, or the previous one, or absent (docs/FORMATS.md).

#include "bake/error.h"

#include <cstddef>
#include <filesystem>
#include <span>

namespace reliefbake {

/// Temporary in the same directory (O_EXCL), checked write, fsync, rename, fsync of the directory. On any error the
/// temporary is gone and `path` is untouched. A symbolic link stays; the file it names is replaced. Thread-safe.
/// Errors: cannot_create (no such directory, no permission, not a regular file), write_failed (disk full, ...).
/// Only SIGKILL and a power cut leave a temporary behind: .reliefbake-PID-N.tmp, safe to delete.
Result<void> write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes temporaries of writes in progress, which then fail; async-signal-safe. The last call of a SIGINT or SIGTERM
/// handler before _exit.
void remove_temporaries_on_signal() noexcept;

} // namespace reliefbake
