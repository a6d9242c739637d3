#pragma once
// reliefbake cone IN -o OUT

#include "cli/command.h"
#include "cli/cone_options.h"

namespace reliefbake {

/// The stages of every cone command: read, bake, encode, write, tell.
Result<void> bake_planned(const ConeCommandOptions& options);

class ConeCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    ConeCommandOptions options_;
};

} // namespace reliefbake
