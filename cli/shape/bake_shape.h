#pragma once
// reliefbake shape IN -o OUT

#include "cli/command.h"
#include "cli/command_files.h"
#include "cli/shape/shape_options.h"

namespace reliefbake {

class ShapeCommand : public Command, public PlannedCommand {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;
    Result<CommandFiles> files() const override;

  private:
    ShapeCommandOptions options_;
};

} // namespace reliefbake
