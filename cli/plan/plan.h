#pragma once
// reliefbake plan DIR|GLOB|@LIST... --out DIR --emit commands|ninja|slurm|k8s

#include "cli/batch/batch_sources.h"
#include "cli/command.h"

#include <string>

namespace reliefbake {

class PlanCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    enum class Emit { commands, ninja, slurm, k8s };
    Result<void> check_options() const;
    Result<std::string> text() const;

    BatchSources given_;
    Emit emit_ = Emit::commands;
    std::string program_, image_, claim_, file_;
    int shards_ = 0;
};

} // namespace reliefbake
