#pragma once
// Runs the built tool as a user's shell does.

#include <filesystem>
#include <string>

namespace reliefbake::test {

struct Outcome {
    int status; ///< exit status
    std::string out, err;
};

/// Runs `reliefbake ARGUMENTS` through the shell in an empty folder of this process; `environment` is put
/// before it
/// ("LC_ALL=C TZ=UTC").
Outcome run_tool(const std::string& arguments, const std::string& environment = "");

/// The folder where run_tool works; removed at the end of the process.
const std::filesystem::path& work_folder();

/// Quoted path of a bundled height map.
std::string height_map(const std::string& name);

std::string bytes_of(const std::filesystem::path& file);

} // namespace reliefbake::test
