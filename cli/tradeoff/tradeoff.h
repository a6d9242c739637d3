#pragma once
// reliefbake tradeoff MAP|HEIGHT...: what a choice of map, technique and steps costs and brings.

#include "cli/command.h"
#include "cli/cone/cone_options.h"
#include "cli/tradeoff/judge.h"
#include "cli/tradeoff/sweep_plan.h"
#include "cli/tradeoff/tradeoff_input.h"
#include "cli/tradeoff/tradeoff_report.h"

#include <string>
#include <vector>

namespace reliefbake {

class TradeoffCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    struct Input {
        TradeoffInput read;
        TradeoffSection section;
        std::string key; ///< of all that decides a measurement but the candidate
        std::string pictures; ///< folder of the pictures of its fronts
    };

    void add_axes(CLI::App& app);
    void apply_quick();
    Result<Input> sweep(const std::string& file, const std::string& name, SweepRecord& record);
    Result<void> draw_front(const Input& input) const;
    Result<void> write(const std::vector<TradeoffSection>& sections, const std::vector<Input>& inputs) const;

    ConeCommandOptions given_; ///< how heights are read
    std::vector<std::string> files_;
    std::string folder_ = "tradeoff";
    SweepAxes axes_;
    JudgeOptions judge_;
    int crop_ = 0;
    bool quick_ = false, json_ = false;
    const CLI::App* app_ = nullptr;
    std::size_t measured_anew_ = 0;
};

} // namespace reliefbake
