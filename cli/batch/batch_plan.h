#pragma once
// What a batch would do: pure of any writing, and the same for the same files, recipe and folder.

#include "bake/error.h"
#include "cli/batch/recipe.h"
#include "cli/batch/sources.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace reliefbake {

/// From headers and options alone (docs/BATCH.md has the formulas).
struct Prediction {
    std::int64_t width = 0, height = 0; ///< 0: unknown, or a mesh
    std::uint64_t bytes = 0;            ///< most memory of tool and helper
    double seconds = 0;                 ///< with one thread
};

/// One asset: a file baked into one map, by one run of one command.
struct BatchJob {
    std::string id;                             ///< its first output; no two jobs share one
    std::string source;                         ///< the source's relative name
    std::string rule, kind;
    std::filesystem::path input;                ///< IN
    std::vector<std::filesystem::path> inputs;  ///< IN, and all other files that are read
    std::vector<std::string> options;           ///< of the command, without IN, -o, --threads
    std::vector<std::string> outputs;           ///< all files that may be written, relative to the output folder, with '/'
    std::string arguments;                      ///< CommandFiles::arguments
    std::uint64_t max_bytes = 0;                ///< --max-bytes
    Prediction predicted;
};

struct SkippedFile {
    std::string source, reason;
};

struct BatchPlan {
    std::filesystem::path out;
    std::vector<BatchJob> jobs; ///< in the order of their sources
    std::vector<SkippedFile> skipped;
};

/// Errors: usage (an option of the recipe that its command refuses, two outputs of one name, also where only the case of letters
/// differs, an output that is an input or that leaves `out`, also by a symbolic link; the message names the files).
Result<BatchPlan> plan_batch(const std::vector<SourceFile>& sources, const Recipe& recipe, const std::filesystem::path& out);

/// Whether the job's command has --memory, and its recipe leaves it to the batch.
bool takes_memory(const BatchJob& job);

/// Whether it can be baked within any ceiling, out of core.
bool can_stream(const BatchJob& job);

/// The command line of a job: kind, IN, -o, options, --threads, --json.
std::vector<std::string> command_line(const BatchJob& job, const std::filesystem::path& out, int threads);

} // namespace reliefbake
