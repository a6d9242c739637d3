#pragma once
// Bakes a candidate in memory, marches it and judges it.

#include "cli/tradeoff/judge.h"
#include "cli/tradeoff/representation_baker.h"

namespace reliefbake {

/// Measures candidates of one source; each only as fast as its order lets bakes be shared (RepresentationBaker).
class CandidateMeter {
  public:
    /// `source` outlives the meter and keeps its field. Errors: those of Judge::create.
    static Result<CandidateMeter> create(const BakeSource& source, double depth_scale, const JudgeOptions& options);

    /// Measures marches over a map that is baked, judged on the surface that it stores; `map` outlives the meter.
    static Result<CandidateMeter> create(const ReliefMap& map, const JudgeOptions& options);

    /// No file is read or written. Of a baked map's candidates only the march and what is counted as bytes differ. Deterministic but for times.
    /// Errors: those of check_candidate, RepresentationBaker::bake, Judge::load and Judge::measure.
    Result<Measurement> measure(const Candidate& candidate);

    /// The candidate's march over a map that is baked already, as its file was read, judged on the meter's own surface. Errors: as measure.
    Result<Measurement> measure_baked(const ReliefMap& map, const Candidate& candidate);

    /// What it looks like (Judge::picture). Errors: those of measure.
    Result<JudgePicture> picture(const Candidate& candidate);

  private:
    struct Loaded {
        std::size_t texels;
        double bake_seconds;
    };
    explicit CandidateMeter(Judge judge) : judge_(std::move(judge)) {}
    Result<Loaded> load(const Candidate& candidate);
    Result<Measurement> judge(const Loaded& loaded, const Candidate& candidate);

    Judge judge_;
    std::optional<RepresentationBaker> baker_; ///< none for a map that is baked
    std::optional<Representation> loaded_;
};

} // namespace reliefbake
