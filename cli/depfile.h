#pragma once
// -MF: what a bake read, in the syntax of make, as compilers write it.

#include "bake/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbake {

/// "target: input input\n"; blanks, '#', '$' and '\' before them are escaped as GCC does. Errors: usage (a name with a line break, which make
/// cannot read).
Result<std::string> depfile_text(const std::vector<std::string>& targets, const std::vector<std::filesystem::path>& inputs);

} // namespace reliefbake
