#pragma once
// reliefbake bump IN -o OUT --kind derivative|normal|horizon

#include "cli/bump/bump_options.h"
#include "cli/command.h"
#include "cli/command_files.h"

namespace reliefbake {

class BumpCommand : public Command, public PlannedCommand {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;
    Result<CommandFiles> files() const override;

  private:
    BumpCommandOptions options_;
};

} // namespace reliefbake
