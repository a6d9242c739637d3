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

    /// No file is read or written. Deterministic but for times.
    /// Errors: those of check_candidate, RepresentationBaker::bake, Judge::load and Judge::measure.
    Result<Measurement> measure(const Candidate& candidate);

  private:
    CandidateMeter(Judge judge, RepresentationBaker baker) : judge_(std::move(judge)), baker_(std::move(baker)) {}

    Judge judge_;
    RepresentationBaker baker_;
    std::optional<Representation> loaded_;
};

} // namespace reliefbake
