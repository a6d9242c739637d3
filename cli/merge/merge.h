#pragma once
// reliefbake merge BAND... -o OUT

#include "cli/command.h"

#include <string>
#include <vector>

namespace reliefbake {

class MergeCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    std::vector<std::string> inputs_;
    std::string output_;
    int threads_ = 0;
    bool json_ = false, quiet_ = false;
};

} // namespace reliefbake
