#pragma once
// --mips and --trilinear.

#include "cli/cone/cone_options.h"

namespace reliefbake {

void add_mip_options(CLI::App& app, ConeCommandOptions& options);

/// Refuses (usage) --trilinear without --mips, and where a blend of two levels keeps no guarantee: only conservative cones of
/// the bilinear surface, read with filtering, have one to keep.
/// `cone`: with the family resolved.
Result<void> validate_mips(const ConeCommandOptions& options, const ConeOptions& cone);

} // namespace reliefbake
