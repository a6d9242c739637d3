#pragma once
// A file at a final name is complete, or the previous one, or absent (docs/FORMATS.md).

#include "bake/error.h"

#include <cstddef>
#include <filesystem>
#include <span>

namespace reliefbake {

/// Temporary in the same directory (O_EXCL), checked write, fsync, rename, fsync of the directory. On any error the
/// temporary is gone and `path` is untouched. Errors: cannot_create, write_failed.
Result<void> write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes temporaries of writes in progress; async-signal-safe, for SIGINT and SIGTERM.
void remove_temporaries_on_signal() noexcept;

} // namespace reliefbake
