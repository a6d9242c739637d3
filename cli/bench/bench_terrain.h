#pragma once
// reliefbake bench terrain -o OUT --width W --height H: large height maps to bake, of which every texel is known.

#include "cli/command.h"

#include <cstdint>
#include <string>

namespace reliefbake {

class BenchTerrainCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    std::string output_;
    int width_ = 4096, height_ = 4096;
    std::uint32_t seed_ = 1;
    int threads_ = 0;
};

} // namespace reliefbake
