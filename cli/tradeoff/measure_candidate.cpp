#include "cli/tradeoff/measure_candidate.h"

#include "cli/tradeoff/instruction_cost.h"
#include "shaders-reference/measure/stored_depth.h"

namespace reliefbake {

Result<CandidateMeter> CandidateMeter::create(const BakeSource& source, double depth_scale, const JudgeOptions& options) {
    Result<Judge> judge = Judge::create(quantise_depth(*source.field, BitDepth::float32), depth_scale, options);
    if (!judge) return tl::unexpected(judge.error());
    CandidateMeter meter(std::move(*judge));
    meter.baker_.emplace(source, depth_scale, options.threads);
    return meter;
}

Result<CandidateMeter> CandidateMeter::create(const ReliefMap& map, const JudgeOptions& options) {
    Result<Judge> judge = Judge::create(stored_depth(map), map.info.depth_scale, options);
    if (!judge) return tl::unexpected(judge.error());
    if (Result<void> loaded = judge->load(map); !loaded) return tl::unexpected(loaded.error());
    return CandidateMeter(std::move(*judge));
}

Result<CandidateMeter::Loaded> CandidateMeter::load(const Candidate& candidate) {
    if (Result<void> fits = check_candidate(candidate); !fits) return tl::unexpected(fits.error());
    if (!baker_) return Loaded{judge_.source_texels(), 0};
    const Result<const BakedRepresentation*> baked = baker_->bake(candidate.map);
    if (!baked) return tl::unexpected(baked.error());
    const ReliefMap& map = (*baked)->map;
    if (loaded_ != candidate.map) {
        loaded_.reset();
        if (Result<void> loaded = judge_.load(map); !loaded) return tl::unexpected(loaded.error());
        loaded_ = candidate.map;
    }
    return Loaded{map.depth.size(), (*baked)->seconds};
}

Result<Measurement> CandidateMeter::judge(const Loaded& loaded, const Candidate& candidate) {
    Result<Measurement> measured = judge_.measure(candidate.march);
    if (!measured) return measured;
    measured->bytes = double(loaded.texels) * bytes_per_texel(candidate);
    measured->bytes_per_texel = measured->bytes / double(judge_.source_texels());
    measured->bake_seconds = loaded.bake_seconds;
    measured->instructions = instruction_cost(candidate, measured->steps_mean, measured->refining_steps_mean, measured->fetches_mean);
    return measured;
}

Result<Measurement> CandidateMeter::measure(const Candidate& candidate) {
    return load(candidate).and_then([&](const Loaded& loaded) { return judge(loaded, candidate); });
}

Result<Measurement> CandidateMeter::measure_baked(const ReliefMap& map, const Candidate& candidate) {
    loaded_.reset();
    if (Result<void> fits = check_candidate(candidate); !fits) return tl::unexpected(fits.error());
    if (Result<void> loaded = judge_.load(map); !loaded) return tl::unexpected(loaded.error());
    return judge({map.depth.size(), 0}, candidate);
}

Result<JudgePicture> CandidateMeter::picture(const Candidate& candidate) {
    return load(candidate).and_then([&](const Loaded&) { return judge_.picture(candidate.march); });
}

} // namespace reliefbake
