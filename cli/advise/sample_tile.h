#pragma once
// A small tile that stands for a large field while candidates are first measured.

#include "bake/height_field.h"
#include "cli/tradeoff/candidate.h"

#include <string>

namespace reliefbake {

/// The square of `side` texels in the middle of the field and its mirror images: a tile of twice the side that repeats without a seam.
/// `name`: of the file, for messages. Errors: those of make_height_field.
Result<HeightField> sample_tile(const HeightField& field, int side, const std::string& name);

/// The same candidate where a texture width is `widths` times as short: caps of cones grow in step.
Candidate on_tile(Candidate candidate, double widths);

} // namespace reliefbake
