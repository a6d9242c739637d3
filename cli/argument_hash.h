#pragma once
// One number for the options that fix a result.

#include "cli/cone/cone_options.h"

#include <string>

namespace reliefbake {

/// XXH3-128, as 32 hex digits, of the canonical text of every option that can change a byte of the map. File
/// names, threads and what is printed are not part of it; an option given its default value is the option not
/// given.
std::string argument_hash(const ConePlan& plan);

/// The canonical text of the options that say which heights are baked.
std::string source_text(const ConeCommandOptions& options);

/// The hash of such a text.
std::string hash_of_options(const std::string& text);

} // namespace reliefbake
