#pragma once
// What a command tells of a run before it works, for who plans many runs.

#include "bake/bit_depth.h"
#include "bake/error.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace reliefbake {

/// What one run of a command reads and writes, and the options that decide the bytes.
struct CommandFiles {
    std::vector<std::filesystem::path> inputs;  ///< IN first; then other files that are read
    std::vector<std::filesystem::path> outputs; ///< -o first, or its first file; then all others that may be written
    std::string arguments;                      ///< canonical text: equal for equal bytes from equal inputs; names no path
    double planes = 1;       ///< of cones, beside the four of a map; for predictions
    double sample_bytes = 2; ///< of one stored sample
    bool mips = false;
    std::uint64_t max_bytes = 0; ///< --max-bytes
};

/// A command that bakes one file, and can be a part of a batch.
class PlannedCommand {
  public:
    virtual ~PlannedCommand() = default;

    /// The files of a run with the options as parsed. Errors: usage (options that do not fit each other).
    virtual Result<CommandFiles> files() const = 0;
};

/// While it lives, this thread's commands do not mind that the folders of their outputs are missing or cannot be written: they plan.
class FoldersMadeLater {
  public:
    FoldersMadeLater();
    ~FoldersMadeLater();
    FoldersMadeLater(const FoldersMadeLater&) = delete;
    FoldersMadeLater& operator=(const FoldersMadeLater&) = delete;

  private:
    bool outer_;
};

bool folders_are_made_later();

inline int bytes_of_sample(BitDepth bits) { return bits == BitDepth::unorm8 ? 1 : bits == BitDepth::float32 ? 4 : 2; }

} // namespace reliefbake
