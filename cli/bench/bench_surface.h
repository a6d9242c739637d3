#pragma once
// reliefbake bench surface NAME -o MESH

#include "cli/bench/revolved.h"
#include "cli/command.h"

#include <string>

namespace reliefbake {

class BenchSurfaceCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    RevolvedSurface surface_;
    int segments_ = 64;
    int shear_ = 0;
    double scale_ = 1;
    std::string output_;
    bool json_ = false;
};

} // namespace reliefbake
