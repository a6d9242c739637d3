#pragma once
// DIR, GLOB, FILE and @LIST as files.

#include "bake/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbake {

struct SourceFile {
    std::string relative;       ///< to the folder that was given, with '/'; the output lies at the same place below --out
    std::filesystem::path path; ///< to open
};

/// The files that are meant, each once, in the order of the bytes of their names, whichever order the disk has. Folders are searched
/// through; hidden names are left out, and what lies in `out`. Relative to: DIR; the part of GLOB before its first wildcard; a
/// FILE's own folder. A list has one FILE a line, blank lines and '#' lines apart, relative to the working folder, where a
/// relative name keeps its folders. Errors: no_input (no such folder, file or list; a pattern that matches nothing); usage (`out` is a folder
/// of sources).
Result<std::vector<SourceFile>> find_sources(const std::vector<std::string>& given, const std::filesystem::path& out);

} // namespace reliefbake
