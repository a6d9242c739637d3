#pragma once
// reliefbake advise HEIGHT: the cheapest map and march that a measurement shows to meet a budget.

#include "cli/advise/advice_report.h"
#include "cli/command.h"
#include "cli/cone/cone_options.h"
#include "cli/tradeoff/measure_candidate.h"

#include <optional>
#include <string>

namespace reliefbake {

class AdviseCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    /// The source, and who measures on it; made when first needed.
    struct Bench {
        BakeSource source;
        std::optional<BakeSource> tile; ///< of a large one, for the screen
        std::optional<CandidateMeter> proof, screen;
    };

    void add_budget(CLI::App& app);
    Result<void> check_options();
    Result<Measurement> prove(Bench& bench, const Candidate& candidate);
    Result<Measurement> screen(Bench& bench, const Candidate& candidate, const AdviceReport& report);
    Result<void> find(Bench& bench, AdviceReport& report);
    Result<void> apply(Bench& bench, AdviceReport& report);

    ConeCommandOptions given_; ///< how heights are read, proportions, threads
    Budget budget_;
    ShaderTarget target_ = ShaderTarget::glsl;
    JudgeOptions judge_;
    int crop_ = 128; ///< --crop
    bool json_ = false, apply_ = false;
    std::string output_;
    double depth_scale_ = 0;
};

} // namespace reliefbake
