#pragma once
// reliefbake bench also FILE: what several maps of one source save in one run.

#include "cli/command.h"
#include "cli/cone/cone_options.h"

#include <string>
#include <vector>

namespace reliefbake {

class BenchAlsoCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    ConeCommandOptions options_; ///< those of a run
    std::vector<std::string> maps_; ///< --map
    int repeat_ = 5;             ///< --repeat
};

} // namespace reliefbake
