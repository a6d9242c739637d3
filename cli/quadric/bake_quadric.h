#pragma once
// reliefbake quadric MESH -o OUT

#include "cli/command.h"
#include "cli/command_files.h"
#include "cli/quadric/quadric_options.h"

namespace reliefbake {

class QuadricCommand : public Command, public PlannedCommand {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;
    Result<CommandFiles> files() const override;

  private:
    QuadricCommandOptions options_;
};

} // namespace reliefbake
