#pragma once
// reliefbake cone IN -o OUT

#include "cli/command.h"
#include "cli/cone_options.h"

namespace reliefbake {

class ConeCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    Result<void> bake(const ConePlan& plan);

    ConeCommandOptions options_;
};

} // namespace reliefbake
