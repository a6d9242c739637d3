#pragma once
// A file of lines that are each on the disk before their writer goes on: the commit records of a long run.

#include "bake/error.h"
#include "formats/unique_fd.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// A folder that one run at a time may hold, or several that know of each other, by a lock that goes with the process, however it ends.
class FolderLock {
  public:
    enum class Hold { alone, together };
    /// Makes FILE where it is missing and locks it. None where another process holds it, alone or (asked for alone) at all. Errors: cannot_create.
    static Result<std::optional<FolderLock>> take(const std::filesystem::path& file, Hold hold = Hold::alone);

  private:
    explicit FolderLock(UniqueFd fd) : fd_(std::move(fd)) {}
    UniqueFd fd_;
};

class Journal {
  public:
    /// Opens or creates it; whoever opens it to write must be alone (FolderLock). A last line without its end, as a power cut leaves
    /// one, is cut off. Errors: cannot_create, write_failed.
    static Result<Journal> open(const std::filesystem::path& path);

    /// The lines of a journal that may be missing (then none), without writing to it. Errors: no_input.
    static Result<std::vector<std::string>> read(const std::filesystem::path& path);

    /// The lines that were there when it was opened, without their ends.
    const std::vector<std::string>& lines() const { return lines_; }

    /// Adds a line, which holds no end of its own, and returns when it is on the disk. A line that could not be written whole is cut
    /// off again. Errors: write_failed.
    Result<void> append(const std::string& line);

    /// Puts `lines` in the place of all there are: the old or the new file, never less. Errors: cannot_create, write_failed.
    Result<void> replace(const std::vector<std::string>& lines);

  private:
    Journal(UniqueFd fd, std::filesystem::path path) : fd_(std::move(fd)), path_(std::move(path)) {}
    tl::unexpected<Error> failed(const char* action) const;

    UniqueFd fd_;
    std::filesystem::path path_;
    std::vector<std::string> lines_;
};

} // namespace reliefbake
