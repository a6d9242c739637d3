#pragma once
// reliefbake explain FILE [--json [--histogram N]]

#include "cli/command.h"
#include "formats/map_file.h"

#include <string>

namespace reliefbake {

class ExplainCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    struct Options {
        std::string file;
        MapHints hints;
        bool json = false;
        int bins = 0; ///< of --histogram; 0 without
    } options_;
};

} // namespace reliefbake
