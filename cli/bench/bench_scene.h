#pragma once
// reliefbake bench scene SCENE -o DIR: a scene's own maps, and everything, baked and timed.

#include "cli/command.h"

#include <string>

namespace reliefbake {

class BenchSceneCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    std::string file_, folder_;
    int threads_ = 0;
};

} // namespace reliefbake
