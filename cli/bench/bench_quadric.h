#pragma once
// reliefbake bench quadric

#include "cli/command.h"

namespace reliefbake {

class BenchQuadricCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    int rings_ = 1024;   ///< --rings, of the torus that is timed
    int sides_ = 1024;   ///< --sides
    int repeat_ = 5;     ///< --repeat: the fastest run counts
    int threads_ = 0;    ///< --threads
    bool accuracy_ = false; ///< --accuracy: surfaces of known curvature instead
    bool json_ = false;
};

} // namespace reliefbake
