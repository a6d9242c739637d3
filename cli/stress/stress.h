#pragma once
// reliefbake stress: what is promised, at the ends of what numbers, sizes and proportions allow.

#include "cli/command.h"
#include "cli/stress/stress_report.h"

namespace reliefbake {

class StressCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    StressExtent extent() const;
    Result<std::vector<StressField>> wanted_fields() const;
    Result<std::vector<StressResult>> run_field(const StressField& field) const;
    Result<void> write(const nlohmann::json& report, const std::vector<Usefulness>& measured) const;

    std::string folder_;              ///< -o
    std::optional<std::string> only_; ///< --only
    bool json_ = false, quick_ = false, full_ = false;
    StressEffort effort_; ///< --threads
};

} // namespace reliefbake
