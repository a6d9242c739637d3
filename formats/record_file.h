#pragma once
// A file of lines that only grows: what a long run has finished, kept through any interruption.

#include "bake/error.h"
#include "formats/unique_fd.h"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbake {

class RecordFile {
  public:
    /// Opens or creates it. A last line without its end, as a power cut may leave one, is taken off. One program at a time:
    /// errors (usage) where another holds it; cannot_create.
    static Result<RecordFile> open(const std::filesystem::path& path);

    /// The lines that were there, without their ends.
    const std::vector<std::string>& lines() const { return lines_; }

    /// Adds a line, in one write. `line` has no end of its own. Errors: write_failed.
    Result<void> append(const std::string& line);

  private:
    RecordFile(UniqueFd fd, std::string name) : fd_(std::move(fd)), name_(std::move(name)) {}
    Result<void> read_lines();

    UniqueFd fd_;
    std::string name_;
    std::vector<std::string> lines_;
};

} // namespace reliefbake
