#pragma once
// reliefbake bench dynamic: anisotropic maps of a moving surface (002 sec. III, fig. 7).

#include "cli/command.h"

namespace reliefbake {

class BenchDynamicCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    int size_ = 128;   ///< --size: side of the map
    int frames_ = 20;  ///< --frames
    int sectors_ = 4;  ///< --sectors
    int threads_ = 0;  ///< --threads
    bool json_ = false;
};

} // namespace reliefbake
