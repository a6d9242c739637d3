#pragma once
// advise --apply: the answer as a file.

#include "cli/advise/choose.h"
#include "cli/cone/cone_options.h"

#include <functional>
#include <string>

namespace reliefbake {

/// Refuses (usage) an output that is the input, or of a format that does not say what its map means; cannot_create.
Result<void> check_apply(const std::string& input, const std::string& output);

/// Whether one file of the output's format holds the map with its normals and depth.
bool can_hold(const std::string& output, const Representation& map);

/// Bakes what `reliefbake` + bake_command_text bakes, reads the file back and measures it: its figures must be the answer's, else the
/// file is removed (internal). `source`: how heights are read, proportions, threads. Errors: those of plan_cone, bake_maps, read_map, `measure`.
Result<void> apply_advice(const ConeCommandOptions& source, const std::string& output, const Trial& answer, const std::function<Result<Measurement>(const ReliefMap&)>& measure);

} // namespace reliefbake
