#include "cli/tradeoff/measure_candidate.h"

namespace reliefbake {

Result<CandidateMeter> CandidateMeter::create(const BakeSource& source, double depth_scale, const JudgeOptions& options) {
    Result<Judge> judge = Judge::create(quantise_depth(*source.field, BitDepth::float32), depth_scale, options);
    if (!judge) return tl::unexpected(judge.error());
    return CandidateMeter(std::move(*judge), RepresentationBaker(source, depth_scale, options.threads));
}

Result<Measurement> CandidateMeter::measure(const Candidate& candidate) {
    if (Result<void> fits = check_candidate(candidate); !fits) return tl::unexpected(fits.error());
    const Result<const BakedRepresentation*> baked = baker_.bake(candidate.map);
    if (!baked) return tl::unexpected(baked.error());
    const ReliefMap& map = (*baked)->map;
    if (loaded_ != candidate.map) {
        loaded_.reset();
        if (Result<void> loaded = judge_.load(map); !loaded) return tl::unexpected(loaded.error());
        loaded_ = candidate.map;
    }
    Result<Measurement> measured = judge_.measure(candidate.march);
    if (!measured) return measured;
    const double texels = double(map.depth.size());
    measured->bytes = texels * bytes_per_texel(candidate);
    measured->bytes_per_texel = measured->bytes / double(judge_.source_texels());
    measured->bake_seconds = (*baked)->seconds;
    return measured;
}

} // namespace reliefbake
