#pragma once
// What a bake will cost, told from the header of its input and its options.

#include "cli/batch/batch_plan.h"
#include "cli/command_files.h"

namespace reliefbake {

/// N texels, P planes of cones, s bytes a stored sample, M = 4/3 with mips, else 1; upper bounds (docs/BATCH.md):
///   maps:   M N (24 + 8 P + 4 s P') + M 3 (4 s N P') + 150 MB, P' = max(1, P / 4);   meshes: 60 F + 20 MB, F the file's bytes
Prediction predict_bake(const std::string& kind, const CommandFiles& files);

} // namespace reliefbake
